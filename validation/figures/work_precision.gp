# Error against cost, in evaluations of the right-hand side and in CPU seconds. Given: names (between semicolons) and styles (words)
# of the curves, count, low (the smallest error that can be told), and for each cost (evaluations, cpu) the blocks curves_ (curve cost
# error least most), failures_ (curve cost) and star_ (cost error).
set terminal svg size 960, 460 font 'sans-serif,15' enhanced
set border 3 lw 0.8
set logscale xy
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set format y '10^{%L}'
set format x '10^{%L}'
set grid xtics ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set bmargin at screen 0.14
set tmargin at screen 0.96

set style line 1 lc rgb '#000000' lw 2 pt 7 ps 0.5
set style line 2 lc rgb '#000000' lw 1.2 pt 6 ps 0.5 dt (6, 3)
set style line 3 lc rgb '#000000' lw 1.2 pt 9 ps 0.5 dt (2, 3)
set style line 4 lc rgb '#cc79a7' lw 1.5 pt 5 ps 0.5
set style line 5 lc rgb '#0072b2' lw 1.8 pt 13 ps 0.7
set style line 6 lc rgb '#e69f00' lw 1.5 pt 4 ps 0.5 dt (6, 3)
set style line 7 lc rgb '#e69f00' lw 1.8 pt 5 ps 0.5
set style line 8 lc rgb '#009e73' lw 1.8 pt 11 ps 0.6
set style line 9 lc rgb '#d55e00' lw 1.8 pt 9 ps 0.6
set style line 10 lc rgb '#000000' lw 1.6 pt 6 ps 0.6 dt (8, 4, 2, 4)
set style line 11 lc rgb '#0072b2' lw 1.6 pt 12 ps 0.7 dt (8, 4, 2, 4)
set style line 12 lc rgb '#009e73' lw 1.6 pt 10 ps 0.7 dt (8, 4, 2, 4)
set style line 13 lc rgb '#000000' lw 2.2 pt 4 ps 0.6 dt (1, 2)
set style line 14 lc rgb '#0072b2' lw 2.2 pt 12 ps 0.7 dt (1, 2)
set style line 15 lc rgb '#009e73' lw 2.2 pt 10 ps 0.7 dt (1, 2)
set style line 16 lc rgb '#6a3d9a' lw 1.5 pt 5 ps 0.5
set style line 21 lc rgb '#606060' lw 1.6 pt 2 ps 0.3
set style line 22 lc rgb '#8a8a8a' lw 1.6 pt 2 ps 0.3 dt (6, 3)
set style line 23 lc rgb '#606060' lw 1.6 pt 2 ps 0.3 dt (2, 3)
set style line 24 lc rgb '#8a8a8a' lw 1.6 pt 2 ps 0.3 dt (8, 3, 2, 3)
set style line 25 lc rgb '#8a8a8a' lw 2.6 pt 2 ps 0.3 dt (1, 3)
set style line 30 lc rgb '#000000' lw 1.2 pt 3 ps 1.4

array name_of[count]
array style[count]
rest = names
do for [i=1:count] {
  at = strstrt(rest, ';')
  name_of[i] = at > 0 ? rest[1:at - 1] : rest
  rest = at > 0 ? rest[at + 1:*] : ''
  style[i] = int(word(styles, i))
}
top = 3.0
set yrange [0.5 * low:top]
mine(i, value) = column(1) == i ? value : NaN

set multiplot
set lmargin at screen 0.085
set rmargin at screen 0.415
set xlabel 'evaluations of the right-hand side' offset 0, 0.3
set ylabel 'error' offset 0.4, 0
set arrow 1 from graph 0, first low to graph 1, first low nohead lc rgb '#606060' lw 0.8 dt (5, 4)
unset key
plot for [i=1:count] $curves_evaluations using (mine(i, $2)):3 with linespoints ls style[i], \
     for [i=1:count] $failures_evaluations using (mine(i, $2)):(0.75 * top) with points lc rgb (style[i] > 20 ? 0xa0a0a0 : 0xcc0000) pt 2 ps 0.5 lw 1, \
     $star_evaluations using 1:2 with points ls 30

set lmargin at screen 0.46
set rmargin at screen 0.78
set xlabel 'CPU time [s]' offset 0, 0.3
unset ylabel
set format y ''
set key at screen 0.79, screen 0.985 left top vertical Left reverse noenhanced samplen 1.8 spacing 1.0 font ',14'
plot for [i=1:count] $curves_cpu using (mine(i, $2)):3 with linespoints ls style[i] title name_of[i], \
     for [i=1:count] $curves_cpu using (mine(i, $2)):3:4:5 with xerrorbars ls style[i] pt 0 dt 1 lw 0.6 notitle, \
     for [i=1:count] $failures_cpu using (mine(i, $2)):(0.75 * top) with points lc rgb (style[i] > 20 ? 0xa0a0a0 : 0xcc0000) pt 2 ps 0.5 lw 1 notitle, \
     NaN with points lc rgb '#cc0000' pt 2 ps 0.5 lw 1 title 'failed', \
     $star_cpu using 1:2 with points ls 30 title 'pece at 1e-4 s'
unset multiplot
