# Error against cost, in evaluations of the right-hand side and in CPU seconds, in layers: the paper's method and the winners at the
# paper's error thick, the rest faint, each named under the pointer. Given: names (between semicolons) and styles (words) of the curves, first
# (words: 1 if it stands in front), count, low (the smallest error that can be told), need (the paper's own error), and for each cost
# (evaluations, cpu) the blocks curves_ (curve cost error least most name), failures_ (curve cost name) and star_ (cost error).
set terminal svg size 960, 720 font 'sans-serif,15' enhanced
set border 3 lw 0.8
stats $curves_evaluations using 2 name 'cost' nooutput
set logscale xy
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set format y '10^{%L}'
set format x '10^{%L}'
set grid xtics ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set bmargin at screen 0.42
set tmargin at screen 0.965

# Marks and dashes by style, colours by method.
array mark[30]
array dash[30]
do for [i=1:30] { mark[i] = 7; dash[i] = 1 }
mark[2] = 6; mark[3] = 9; mark[4] = 5; mark[5] = 13; mark[6] = 4; mark[7] = 5; mark[8] = 11; mark[9] = 9; mark[10] = 6; mark[11] = 12
mark[12] = 10; mark[13] = 4; mark[14] = 12; mark[15] = 10; mark[16] = 15
dash[2] = 2; dash[3] = 3; dash[6] = 2; dash[10] = 4; dash[11] = 4; dash[12] = 4; dash[13] = 5; dash[14] = 5; dash[15] = 5; dash[16] = 4
do for [i=21:25] { mark[i] = 2; dash[i] = i - 20 }

array name_of[count]
array style[count]
array front[count]
rest = names
do for [i=1:count] {
  at = strstrt(rest, ';')
  name_of[i] = at > 0 ? rest[1:at - 1] : rest
  rest = at > 0 ? rest[at + 1:*] : ''
  style[i] = int(word(styles, i))
  front[i] = int(word(first, i))
}
faint(i) = front[i] ? 0x00000000 : 0x99000000
tone(i) = faint(i) + colour_of_method(base_of(name_of[i]))
thick(i) = front[i] ? 2.6 : 1.2
size(i) = front[i] ? 0.6 : 0.4
top = 3.0
set yrange [0.5 * low:top]
mine(i, value) = column(1) == i ? value : NaN

set multiplot
set lmargin at screen 0.095
set rmargin at screen 0.52
set xlabel 'evaluations of the right-hand side' offset 0, 0.3
set label 1 'error' at screen 0.018, screen 0.69 center rotate
set arrow 1 from graph 0, first low to graph 1, first low nohead lc rgb '#606060' lw 0.8 dt (2, 3)
set arrow 2 from graph 0, first need to graph 1, first need nohead lc rgb '#a33b00' lw 0.8 dt (6, 4)
set label 2 'the error of the paper' at graph 0.99, first need right offset 0, 0.5 tc rgb '#a33b00' font ',13'
set label 3 'better' at graph 0.015, graph 0.04 left font ',13' tc rgb '#606060'
# Slopes to compare with: error falls as cost^-1, -2, -4.
from = cost_max / 10**0.7
do for [k=1:3] {
  slope = 2**(k - 1)
  set arrow 10 + k from from, 0.6 * top to from * 10**0.5, 0.6 * top * 10**(-0.5 * slope) nohead lc rgb '#8a8a8a' lw 1
  set label 10 + k sprintf('%d', slope) at from * 10**0.5, 0.6 * top * 10**(-0.5 * slope) left offset 0.3, 0 tc rgb '#606060' font ',13'
}
set key off noenhanced
plot for [i=1:count] $curves_evaluations using (mine(i, $2)):3 with linespoints lc rgb tone(i) lw thick(i) pt mark[style[i]] ps size(i) dt dash[style[i]] title name_of[i], \
     for [i=1:count] $failures_evaluations using (mine(i, $2)):(0.75 * top) with points lc rgb (style[i] > 20 ? 0xa0a0a0 : 0xcc0000) pt 2 ps 0.5 lw 1 title name_of[i].' failed', \
     $star_evaluations using 1:2 with points pt 3 ps 1.6 lw 1.4 lc rgb '#a33b00' title 'pece at 0.1 ms, as in the paper'

set lmargin at screen 0.56
set rmargin at screen 0.985
set xlabel 'CPU time [s]' offset 0, 0.3
unset label 1
do for [k=1:3] { unset arrow (10 + k); unset label (10 + k) }
unset label 2
set format y ''
plot for [i=1:count] $curves_cpu using (mine(i, $2)):3 with linespoints lc rgb tone(i) lw thick(i) pt mark[style[i]] ps size(i) dt dash[style[i]] title name_of[i], \
     for [i=1:count] $curves_cpu using (front[i] ? mine(i, $2) : NaN):3:4:5 with xerrorbars lc rgb tone(i) pt 0 dt 1 lw 0.8 notitle, \
     for [i=1:count] $failures_cpu using (mine(i, $2)):(0.75 * top) with points lc rgb (style[i] > 20 ? 0xa0a0a0 : 0xcc0000) pt 2 ps 0.5 lw 1 title name_of[i].' failed', \
     $star_cpu using 1:2 with points pt 3 ps 1.6 lw 1.4 lc rgb '#a33b00' title 'pece at 0.1 ms, as in the paper'

# The key, whole, below both.
unset arrow 1
unset arrow 2
unset label 3
unset border
unset tics
unset xlabel
unset logscale
set lmargin at screen 0.05
set rmargin at screen 0.98
set tmargin at screen 0.31
set bmargin at screen 0.0
set xrange [0:1]
set yrange [0:1]
set key center center horizontal maxrows 8 Left reverse noenhanced samplen 2.4 width 1 font ',13'
plot for [i=1:count] NaN with linespoints lc rgb tone(i) lw thick(i) pt mark[style[i]] ps 0.6 dt dash[style[i]] title name_of[i], \
     NaN with points lc rgb '#cc0000' pt 2 ps 0.5 lw 1 title 'failed', \
     NaN with points pt 3 ps 1.4 lw 1.4 lc rgb '#a33b00' title 'pece at 0.1 ms'
unset multiplot
