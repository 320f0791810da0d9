# Force against overlap in an impact, one panel a damping factor. Given: panels, title_1 ..., blocks solver_1 ... and exact_1 ... (overlap force),
# in units of the impact.
set terminal svg size 900, 260 font 'sans-serif,14' enhanced
unset key
set border 3 lw 0.8
set tics nomirror out scale 0.5
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set tmargin at screen 0.86
set bmargin at screen 0.26
set xlabel 'overlap' offset 0, 0.4
set xtics auto
set multiplot
do for [k = 1:panels] {
  left = 0.065 + (k - 1) * 0.94 / panels
  set lmargin at screen left
  set rmargin at screen left + 0.94 / panels - 0.055
  if (k == 1) { set ylabel 'force' offset 1, 0 } else { unset ylabel }
  set title value(sprintf('title_%d', k)) offset 0, -0.5
  set xrange [*:*]
  set yrange [*:*]
  eval sprintf("stats $exact_%d using 1 name 'x' nooutput; stats $exact_%d using 2 name 'y' nooutput", k, k)
  set xrange [0:1.12 * x_max]
  set yrange [0:1.15 * y_max]
  step = 10**floor(log10(x_max))
  set xtics 0, (x_max / step < 2 ? 0.5 * step : x_max / step < 5 ? step : 2 * step)
  eval sprintf("plot $exact_%d using 1:2 with lines lw 3 lc rgb '#9ecae1' title 'closed form', \
    $solver_%d using 1:2 every 2 with points pt 7 ps 0.3 lc rgb '#000000' title 'solver'", k, k)
}
unset multiplot
