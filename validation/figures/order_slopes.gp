# Error against step, a panel for each kind of force. Given: panels, curves, blocks points (panel curve step error), theory (panel
# step error step error), panel (panel low high contact title): contact is 1 if the step is over the duration of a contact, labels (panel step error slope), names (curve 0 name).
if (!exists('curves')) curves = 6  # of a study kept before there was a number
across = 4
down = ceil((panels + 1) / across)
wide = 1080.0
each = 282.0
tall = each * down
set terminal svg size wide, tall font 'sans-serif,13' enhanced
unset key
set border 3 lw 0.8
# One colour a method in all figures; the sixth style is that of all others.
array called[50]
note(k, name) = (called[k + 1] = name, 1)
stats $names using (note(int($1), strcol(3))) nooutput
set style line 1 lc rgb colour_of_method('pece') lw 1.6 pt 7 ps 0.45
set style line 2 lc rgb colour_of_method('ab2') lw 1.4 dt (8, 3) pt 9 ps 0.5
set style line 3 lc rgb colour_of_method('verlet') lw 1.4 dt (4, 2) pt 5 ps 0.4
set style line 4 lc rgb colour_of_method('symplectic_euler') lw 1.4 dt (2, 2) pt 11 ps 0.5
set style line 5 lc rgb colour_of_method('rk4') lw 1.6 pt 4 ps 0.5
set style line 6 lc rgb colour_of_method(curves > 5 ? called[6] : '') lw 1.2 dt (6, 2, 1, 2) pt 6 ps 0.5
set style line 9 lc rgb '#c4c4c4' lw 4
set multiplot
set tics nomirror out scale 0.5
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xtics 10 offset 0, 0.3
set ytics offset 0.5, 0
set mxtics 10
set mytics 1
do for [p=0:panels-1] {
  column_of = p - across * floor(p / across)
  row_of = floor(p / across)
  set lmargin at screen (column_of + 0.22) / across
  set rmargin at screen (column_of + 0.96) / across
  set tmargin at screen 1 - (each * row_of + 34) / tall
  set bmargin at screen 1 - (each * row_of + 214) / tall
  set xrange [*:*]
  set yrange [*:*]
  stats $panel using ($1 == p ? $2 : NaN) name 'low' nooutput
  stats $panel using ($1 == p ? $3 : NaN) name 'high' nooutput
  stats $points using ($1 == p ? $3 : NaN) name 'step' nooutput
  stats $panel using ($1 == p ? $4 : NaN) name 'contact' nooutput
  decades = log10(high_min / low_min)
  set ytics decades > 6 ? 100 : 10
  set xrange [step_min / 2.2:step_max * 1.3]
  set yrange [low_min:high_min]
  set xlabel (contact_max > 0.5 ? 'step {/:Italic h/T}' : 'step {/:Italic hω}') offset 0, 0.9 font ',13'
  if (column_of == 0) { set label 1 'error of the position' at screen 0.009, screen 1 - (each * row_of + 124) / tall center rotate font ',13' } else { unset label 1 }
  plot $theory using ($1 == p ? $2 : NaN):3:($4 - $2):($5 - $3) with vectors nohead ls 9, \
       for [k=0:curves - 1] $points using ($1 == p && $2 == k ? $3 : NaN):4 with linespoints ls (k < 5 ? k + 1 : 6), \
       $labels using ($1 == p ? $2 : NaN):3:(strcol(4)) with labels right offset -0.5, 0 font ',12' tc rgb '#444444', \
       $panel using ($1 == p ? sqrt(step_min * step_max) : NaN):3:(strcol(5)) with labels offset 0, 0.9 font ',14' noenhanced
}
# The key, where the next panel would be.
unset label 1
column_of = panels - across * floor(panels / across)
set lmargin at screen (column_of + 0.2) / across
set rmargin at screen 1
set tmargin at screen 1 - (each * (down - 1) + 34) / tall
set bmargin at screen 1 - (each * (down - 1) + 214) / tall
unset border
unset tics
unset xlabel
unset ylabel
unset logscale
set xrange [0:across - column_of]
last = curves < 6 ? 6 : curves
set yrange [last + 1:-0.5]
plot for [k=0:curves - 1] $names using ($1 == k ? 0 : NaN):0:(0.25):(0) with vectors nohead ls (k < 5 ? k + 1 : 6), \
     for [k=0:curves - 1] $names using ($1 == k ? 0.125 : NaN):0 with points ls (k < 5 ? k + 1 : 6), \
     $names using (0.3):0:(strcol(3)) with labels left font ',14' noenhanced, \
     '+' using (0):(last):(0.25):(0) every ::0::0 with vectors nohead ls 9, \
     '+' using (0.3):(last):('predicted slope') every ::0::0 with labels left font ',14'
unset multiplot
