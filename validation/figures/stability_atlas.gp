# Stable regions as small multiples, the first one large. Given: panels, title_1 ..., blocks theory_1 ... (zeta, omega h), measured_1 ...
# (zeta, by a link, by a contact), points (zeta, omega h, label) and marks, their number. A damping ratio of zero stands at 0.002.
panels = int(panels)
columns = 4
rows = int(ceil((panels - 1) / real(columns)))
first = 330
high = first + 165 * rows + 100
set terminal svg size 800, high font 'sans-serif,14' enhanced
set border 3 lw 0.7 lc rgb '#444444'
set tics nomirror out scale 0.4
set logscale xy
set xrange [0.002:300]
set yrange [0.003:6]
unset key
left = 0.075
wide = 0.225
top = 1 - first / real(high)
tall = 165.0 / high
# Past the last damping ratio a contact creeps, and the limit falls as its inverse.
beyond(k) = sprintf("stats $theory_%d using (last_zeta = $1, last_limit = $2, 1) nooutput", k)
set multiplot
do for [k = 1:panels] {
  column = (k - 2) % columns
  row = (k - 2) / columns
  large = k == 1
  if (large) {
    set lmargin at screen left
    set rmargin at screen 0.78  # names of points stand beside it
    set tmargin at screen 1 - 30.0 / high
    set bmargin at screen 1 - (first - 55.0) / high
  } else {
    set lmargin at screen left + column * wide
    set rmargin at screen left + column * wide + 0.205
    set tmargin at screen top - row * tall - 18.0 / high
    set bmargin at screen top - (row + 1) * tall + 12.0 / high
  }
  if (large || k + columns > panels) {
    set xtics ('0' 0.002, '' 0.01, '0.1' 0.1, '1' 1, '10' 10, '100' 100) offset 0, 0.4
    set xlabel 'damping ratio {/:Italic ζ}' offset 0, 0.9
  } else {
    set xtics ('' 0.002, '' 0.01, '' 0.1, '' 1, '' 10, '' 100)
    unset xlabel
  }
  if (large || column == 0) {
    set ytics ('0.01' 0.01, '0.1' 0.1, '1' 1) offset 0.5, 0
    set ylabel '{/:Italic ωh}' offset 2.2, 0
  } else {
    set ytics ('' 0.01, '' 0.1, '' 1)
    unset ylabel
  }
  title = value(sprintf('title_%d', k))
  set label 1 (large ? title.', the method of the paper' : title) at graph 0, (large ? 1.04 : 1.06) left noenhanced font (strlen(title) > 26 && !large ? ',8.5' : ',13')
  last_zeta = 300
  last_limit = 1
  eval beyond(k)
  size = large ? 1.3 : 1
  eval sprintf("plot $theory_%d using 1:(0.003):2 with filledcurves lc rgb '#cfe5f2' fs solid noborder notitle, \
    [last_zeta:300] (last_limit * last_zeta / x) with filledcurves y1=0.003 lc rgb '#e6f1f8' fs solid noborder notitle, \
    $theory_%d using 1:2 with lines lc rgb '#0072b2' lw 1.5 title 'limit by the amplification factor', \
    [last_zeta:300] (last_limit * last_zeta / x) with lines lc rgb '#0072b2' lw 1.2 dt (4, 3) title 'the limit, continued', \
    $measured_%d using 1:2 with points pt 6 ps 0.55 * size lw 1.3 lc rgb '#d55e00' title 'blow-up of a link', \
    $measured_%d using 1:3 with points pt 2 ps 0.4 * size lw 1 lc rgb '#000000' title 'blow-up of a contact'", k, k, k, k).(marks == 0 ? '' : ", \
    $points using 1:2 with points pt 7 ps (large ? 0.7 : 0.35) lc rgb '#009e73' title 'scenes at the step of the paper'").(marks == 0 || !large ? '' : ", \
    $points using 1:2:3 with labels left offset 0.9, -0.1 font ',13' tc rgb '#00734f' notitle")
}
# The key, below all panels.
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 52.0 / high
unset border
unset tics
unset xlabel
unset ylabel
unset label 1
set xrange [1:10]
set yrange [1:10]
set key center center horizontal maxrows 2 Left reverse samplen 1.5 width 1
plot NaN with filledcurves lc rgb '#cfe5f2' fs solid noborder title 'stable, by the amplification factor', \
     NaN with points pt 6 ps 0.55 lw 1.3 lc rgb '#d55e00' title 'blow-up of a link', \
     NaN with points pt 2 ps 0.4 lc rgb '#000000' title 'of a contact', \
     NaN with points pt 7 ps 0.35 lc rgb '#009e73' title 'scenes at the paper’s step'
unset multiplot
