# Relative change of energy in a period against h omega. Given: curves, last (h omega of their ends), blocks points (curve angle change gain), theory
# (curve angle change), names (curve, change at the label, gain, change at its end, name).
set terminal svg size 760, 460 font 'sans-serif,15' enhanced
unset key
set lmargin at screen 0.12
set rmargin at screen 0.72
set bmargin at screen 0.15
set tmargin at screen 0.97
set border 3 lw 0.8
set tics nomirror out scale 0.6
set logscale xy
set format y '10^{%T}'
set xrange [0.022:0.33]
set yrange [1e-13:10]
set xtics (0.025, 0.05, 0.1, 0.2, 0.3)
set xlabel 'h ω' offset 0, 0.4
set ylabel 'change of energy a period, relative' offset 1, 0
# The names of the curves, for one colour a method in all figures.
array called[50]
note(k, name) = (called[k + 1] = name, 1)
stats $names using (note(int($1), strcol(5))) nooutput
tone(k) = colour_of_method(called[k + 1])
plot for [k=0:curves-1] $theory using ($1 == k ? $2 : NaN):3 with lines lc rgb '#b5b5b5' lw 3, \
     for [k=0:curves-1] $points using ($1 == k ? $2 : NaN):3 with lines lc rgb tone(k) lw 1.4 dt k % 3 + 1 title called[k + 1], \
     for [k=0:curves-1] $points using ($1 == k && $4 == 1 ? $2 : NaN):3 with points pt 7 ps 0.6 lc rgb tone(k), \
     for [k=0:curves-1] $points using ($1 == k && $4 == 0 ? $2 : NaN):3 with points pt 6 ps 0.6 lc rgb tone(k), \
     for [k=0:curves-1] $names using ($1 == k ? last : NaN):4:(0.307 - last):($2 - $4) with vectors nohead lc rgb tone(k) lw 0.7 notitle, \
     for [k=0:curves-1] $names using ($1 == k ? 0.31 : NaN):2:(strcol(5)) with labels left noenhanced tc rgb tone(k) notitle
