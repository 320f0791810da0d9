# How far the force is off, by step, along the way. Given: end (mm), count, blocks off (which, mm, N), names (which, name) and force (mm, N).
set terminal svg size 600, 360 font 'sans-serif,15' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set lmargin at screen 0.135
set rmargin at screen 0.975
set bmargin at screen 0.165
set tmargin at screen 0.89
set xlabel 'displacement of the plate [mm]' offset 0, 0.4
set ylabel 'force, and how far it is off [N]' offset 0.4, 0
set logscale y
set format y '10^{%L}'
set yrange [1e-4:*]
set xrange [0:end]
set key at screen 0.55, screen 0.99 center top horizontal Left reverse samplen 2
array tone[5] = [0x000000, 0xd55e00, 0x0072b2, 0x009e73, 0xcc79a7]
array called[20]
note(k, name) = (called[k + 1] = name, 1)
stats $names using (note(int($1), strcol(2))) nooutput
plot $force using 1:($2 > 0 ? $2 : NaN) with lines lw 1 lc rgb '#c8c8c8' title 'force', \
     for [k = 0:count - 1] $off using ($1 == k ? $2 : NaN):3 with linespoints lw 1.8 pt 7 ps 0.35 lc rgb tone[k + 1] title called[k + 1]
