# Eigenvalues times the step in the complex plane, over a method's stable region, one panel a scene. Given: panels, title_1 ...,
# blocks values_1 ... (real, imaginary part of h lambda, 1 if outside; upper half), region (real, imaginary: its rim, upper half) and reach,
# the left end of all panels. The real axis is stretched near zero, the same for all.
panels = int(panels)
high = 150 * panels + 60
set terminal svg size 760, high font 'sans-serif,15' enhanced
set border 3 lw 0.8 lc rgb '#444444'
set tics nomirror out scale 0.5
set lmargin at screen 0.085
set rmargin at screen 0.97
unset key
set xrange [reach:0.02]
set nonlinear x via -log10(1 - x / 0.3) inverse 0.3 * (1 - 10**(-x))
set multiplot
do for [k = 1:panels] {
  set tmargin at screen 1 - (150.0 * (k - 1) + 28) / high
  set bmargin at screen 1 - (150.0 * k - 20) / high
  set yrange [-0.25:1.6]
  set ytics 0, 1 offset 0.5, 0
  set ylabel 'Im {/:Italic hλ}' offset 1.4, 0
  set xtics (-20, -10, -5, -2, -1, -0.5, -0.2, 0) offset 0, 0.3
  set arrow 2 from -2, graph 0 to -2, graph 1 nohead lw 0.8 dt (4, 4) lc rgb '#d55e00' back
  if (k == panels) { set xlabel 'Re {/:Italic hλ}' offset 0, 0.6 }
  set label 1 value(sprintf('title_%d', k)) at graph 0, 1.1 left font ',14'
  set arrow 1 from 0, graph 0 to 0, graph 1 nohead lw 0.6 lc rgb '#999999' back
  eval sprintf("plot $region using 1:(0):2 with filledcurves lc rgb '#cfe5f2' fs solid noborder, \
    $region using 1:2 with lines lw 1.5 lc rgb '#0072b2', \
    $values_%d using 1:($3 > 0.5 ? $2 : NaN) with points pt 7 ps 0.32 lc rgb '#d55e00', \
    $values_%d using 1:($3 > 0.5 ? NaN : $2) with points pt 7 ps 0.25 lc rgb '#000000'", k, k)
}
unset multiplot
