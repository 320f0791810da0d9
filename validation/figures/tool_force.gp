# Force on driven nodes against their way. Given: count, blocks force (which, mm, N) and names (which, name).
set terminal svg size 900, 320 font 'sans-serif,14' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set lmargin at screen 0.08
set rmargin at screen 0.975
set bmargin at screen 0.18
set tmargin at screen 0.87
set xlabel 'way of the driven nodes [mm]' offset 0, 0.4
set ylabel 'force [N]' offset 0.4, 0
set yrange [0:*]
set key at screen 0.55, screen 0.99 center top horizontal Left reverse samplen 2
array tone[5] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x000000]
array called[20]
note(k, name) = (called[k + 1] = name, 1)
stats $names using (note(int($1), strcol(2))) nooutput
plot for [k = 0:count - 1] $force using ($1 == k ? $2 : NaN):3 with lines lw 1.4 lc rgb tone[k + 1] title called[k + 1]
