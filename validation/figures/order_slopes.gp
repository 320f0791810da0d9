# Error against step, a panel for each kind of force. Given: panels, blocks points (panel curve step error), theory (panel
# step error step error), panel (panel low high title), labels (panel step error slope), names (curve 0 name).
across = 4
down = ceil(panels / across)
wide = 1080.0
tall = 60 + 250.0 * down
set terminal svg size wide, tall font 'sans-serif,13' noenhanced
unset key
set border 3 lw 0.8
set tics nomirror out scale 0.5
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set style line 1 lc rgb '#d55e00' lw 1.6 pt 7 ps 0.45
set style line 2 lc rgb '#cc79a7' lw 1.4 dt (8, 3) pt 9 ps 0.5
set style line 3 lc rgb '#009e73' lw 1.4 dt (4, 2) pt 5 ps 0.4
set style line 4 lc rgb '#b8860b' lw 1.4 dt (2, 2) pt 11 ps 0.5
set style line 5 lc rgb '#0072b2' lw 1.6 pt 4 ps 0.5
set style line 6 lc rgb '#000000' lw 1.2 dt (6, 2, 1, 2) pt 6 ps 0.5
set multiplot
# The key, above all panels.
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
unset border
unset tics
unset logscale
set xrange [0:wide]
set yrange [0:tall]
stats $names using 1 name 'count' nooutput
plot for [k=0:5] $names using ($1 == k ? 60 + 160 * $0 : NaN):(tall - 22):(36):(0) with vectors nohead ls k + 1, \
     for [k=0:5] $names using ($1 == k ? 78 + 160 * $0 : NaN):(tall - 22) with points ls k + 1, \
     $names using (104 + 160 * $0):(tall - 22):3 with labels left font ',14'
set border 3
set tics
set logscale xy
do for [p=0:panels-1] {
  column_of = p - across * floor(p / across)
  row_of = floor(p / across)
  set lmargin at screen (column_of + 0.21) / across
  set rmargin at screen (column_of + 0.97) / across
  set tmargin at screen 1 - (75 + 250.0 * row_of) / tall
  set bmargin at screen 1 - (75 + 250.0 * row_of + 178) / tall
  set xrange [*:*]
  set yrange [*:*]
  stats $panel using ($1 == p ? $2 : NaN) name 'low' nooutput
  stats $panel using ($1 == p ? $3 : NaN) name 'high' nooutput
  stats $points using ($1 == p ? $3 : NaN) name 'step' nooutput
  set xrange [step_min / 2.2:step_max * 1.3]
  set yrange [low_min:high_min]
  set xlabel (row_of == down - 1 || p + across >= panels) ? 'step' : '' offset 0, 0.6
  set ylabel column_of == 0 ? 'error' : '' offset 1.2, 0
  plot $theory using ($1 == p ? $2 : NaN):3:($4 - $2):($5 - $3) with vectors nohead lc rgb '#b5b5b5' lw 3, \
       for [k=0:5] $points using ($1 == p && $2 == k ? $3 : NaN):4 with linespoints ls k + 1, \
       $labels using ($1 == p ? $2 : NaN):3:(strcol(4)) with labels right offset -0.4, 0 font ',12' tc rgb '#555555', \
       $panel using ($1 == p ? sqrt(step_min * step_max) : NaN):3:4 with labels offset 0, 0.9 font ',14'
}
unset multiplot
