# Relative change of energy in a period against h omega. Given: curves, blocks points (curve angle change gain), theory
# (curve angle change), names (curve change gain name).
set terminal svg size 760, 460 font 'sans-serif,15' enhanced
unset key
set lmargin at screen 0.12
set rmargin at screen 0.8
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
array colours[8] = [0xd55e00, 0xe69f00, 0x999999, 0xcc79a7, 0xb8860b, 0x009e73, 0x0072b2, 0x000000]
plot for [k=0:curves-1] $theory using ($1 == k ? $2 : NaN):3 with lines lc rgb '#b5b5b5' lw 3, \
     for [k=0:curves-1] $points using ($1 == k ? $2 : NaN):3 with lines lc rgb colours[k % 8 + 1] lw 1.4 dt k % 3 + 1, \
     for [k=0:curves-1] $points using ($1 == k && $4 == 1 ? $2 : NaN):3 with points pt 7 ps 0.6 lc rgb colours[k % 8 + 1], \
     for [k=0:curves-1] $points using ($1 == k && $4 == 0 ? $2 : NaN):3 with points pt 6 ps 0.6 lc rgb colours[k % 8 + 1], \
     for [k=0:curves-1] $names using ($1 == k ? 0.31 : NaN):2:(strcol(4)) with labels left noenhanced
