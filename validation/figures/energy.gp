# Where the plate's work went, stacked, and below it what the ledger cannot place. Given: end (mm), speed of the plate (mm/s),
# ramp (s) in which it reaches that, start (J): stored energy at t = 0, the file energy of a run, and rows_apart: one row in so many is drawn.
set terminal svg size 600, 410 font 'sans-serif,16' enhanced
rows_apart = int(rows_apart)
mm(t) = speed * (t < ramp ? t**2 / (2 * ramp) : t - ramp / 2)
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.4
set ytics offset 0.6, 0
set lmargin at screen 0.135
set rmargin at screen 0.65
if (end > 200) { set xtics 100 }
stats energy using 14 skip 1 name 'residual' nooutput
stats energy using 13 skip 1 name 'stiffening' nooutput
stats energy using 8 skip 1 name 'viscous' nooutput
stats energy using 10 skip 1 name 'rolling' nooutput
stats energy using 7 skip 1 name 'link' nooutput
stats energy using 11 skip 1 name 'tear' nooutput
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b
low = least(0, least(residual_min, stiffening_min))
high = most(0, most(residual_max, stiffening_max))
span = high > low ? high - low : 1
decade = 10 ** floor(log10(span))
set multiplot

set tmargin at screen 0.97
set bmargin at screen 0.46
set key at screen 0.66, screen 0.98 left top vertical Left reverse invert samplen 1.2 spacing 1.2 width 0
set format x ''
set xrange [0:end]
set yrange [*<0:*]
set ylabel 'energy [J]' offset 1.2, 0
set style fill solid 0.85 noborder
stored(k) = column(2) + column(3) + column(4) + column(5) + column(6) - start
plot energy using (mm($1)):(0):9 every rows_apart skip 1 with filledcurves lc rgb '#e69f00' title 'sliding friction', \
     energy using (mm($1)):9:($9 + $8) every rows_apart skip 1 with filledcurves lc rgb '#56b4e9' title (viscous_max > 0 ? 'contact damping' : ''), \
     energy using (mm($1)):($9 + $8):($9 + $8 + $10) every rows_apart skip 1 with filledcurves lc rgb '#009e73' title (rolling_max > 0 ? 'rolling friction' : ''), \
     energy using (mm($1)):($9 + $8 + $10):($9 + $8 + $10 + $7) every rows_apart skip 1 with filledcurves lc rgb '#f0e442' title (link_max > 0 ? 'link damping' : ''), \
     energy using (mm($1)):($9 + $8 + $10 + $7):($9 + $8 + $10 + $7 + $11) every rows_apart skip 1 with filledcurves lc rgb '#cc79a7' title (tear_max > 0 ? 'tearing' : ''), \
     energy using (mm($1)):($9 + $8 + $10 + $7 + $11):($9 + $8 + $10 + $7 + $11 + stored(0)) every rows_apart skip 1 with filledcurves lc rgb '#0072b2' title 'stored since start', \
     energy using (mm($1)):12 every rows_apart skip 1 with lines lc rgb '#000000' lw 1.5 dt (5, 3) title 'work of the plate'

set tmargin at screen 0.39
set bmargin at screen 0.145
set key at screen 0.66, screen 0.39 left top vertical Left reverse noinvert samplen 1.2
set format x '%g'
set xlabel 'displacement of the plate [mm]' offset 0, 0.7
set ylabel 'not placed [J]' offset 1.2, 0
set yrange [low - 0.04 * span:high + 0.1 * span]
set ytics decade * (span / decade < 2 ? 0.5 : span / decade < 5 ? 1 : 2)
set xzeroaxis lc rgb '#b0b0b0' lw 0.6 dt 1
plot energy using (mm($1)):14 every rows_apart skip 1 with lines lc rgb '#d55e00' lw 1.5 title 'residual', \
     energy using (mm($1)):13 every rows_apart skip 1 with lines lc rgb '#000000' lw 1.2 dt (2, 2) title 'contact stiffening'
unset multiplot
