# Pareto fronts, a panel each problem. Given: count, blocks fronts (problem, CPU s, error, method), stars (problem, CPU s, error), names
# (problem, CPU s, error, CPU s and error of where the name stands, method) and panels (problem, least and most CPU s, least and most error,
# name). A panel is 350 by 175 pixels, as pareto_chart.cpp has it.
across = 2
down = ceil(count / across)
wide = 900.0
each = 250.0
tall = each * down + 10
set terminal svg size wide, tall font 'sans-serif,13' enhanced
set key off noenhanced
set border 3 lw 0.8
set tics nomirror out scale 0.5
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xtics 10 offset 0, 0.3
set mxtics 1
set mytics 1
set grid xtics ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set multiplot
do for [k=0:count-1] {
  column_of = k - across * floor(k / across)
  row_of = floor(k / across)
  left = 62 + 445 * column_of
  upper = 26 + each * row_of
  set lmargin at screen left / wide
  set rmargin at screen (left + 350) / wide
  set tmargin at screen 1 - upper / tall
  set bmargin at screen 1 - (upper + 175) / tall
  set xrange [*:*]  # those of the last panel would hide data from stats
  set yrange [*:*]
  stats $panels using ($1 == k ? $2 : NaN) name 'from' nooutput
  stats $panels using ($1 == k ? $3 : NaN) name 'to' nooutput
  stats $panels using ($1 == k ? $4 : NaN) name 'low' nooutput
  stats $panels using ($1 == k ? $5 : NaN) name 'high' nooutput
  set xrange [from_min:to_min]
  set yrange [low_min:high_min]
  decades = log10(high_min / low_min)
  set ytics 1e-18, (decades > 12 ? 1e4 : decades > 6 ? 100 : 10), 1 offset 0.5, 0
  set xlabel 'CPU time [s]' offset 0, 0.7
  if (column_of == 0) { set label 1 'error [-]' at screen 0.012, screen 1 - (upper + 87) / tall center rotate } else { unset label 1 }
  plot $panels using ($1 == k ? $2 : NaN):5:6 with labels left offset 0, 0.8 font ',14' noenhanced notitle, \
       $names using ($1 == k ? $2 : NaN):3:($4 - $2):($5 - $3) with vectors nohead lc rgb '#b0b0b0' lw 0.7 notitle, \
       $fronts using ($1 == k ? $2 : NaN):3 with linespoints lw 1.8 pt 7 ps 0.35 lc rgb '#0072b2' title 'least error of all methods', \
       $stars using ($1 == k ? $2 : NaN):3 with points pt 3 ps 1.3 lw 1.4 lc rgb '#a33b00' title 'pece at 0.1 ms, as in the paper', \
       $names using ($1 == k ? $4 : NaN):5:6 with labels left font ',12' noenhanced tc rgb '#303030' notitle
}
unset multiplot
