# Pareto fronts, one a problem. Given: count, blocks fronts (problem, CPU s, error, method), stars (problem, CPU s, error) and names (problem,
# CPU s, error, name).
set terminal svg size 900, 480 font 'sans-serif,15' enhanced
unset key
set lmargin at screen 0.115
set rmargin at screen 0.98
set bmargin at screen 0.14
set tmargin at screen 0.97
set border 3 lw 0.8
set tics nomirror out scale 0.6
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set yrange [*:2]
set grid xtics ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set xlabel 'CPU time [s]' offset 0, 0.3
set ylabel 'error [-]' offset 1.2, 0
array tone[8] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xa6761d, 0x56b4e9, 0x000000, 0xe69f00]
array called[20]
note(k, name) = (called[k + 1] = name, 1)
stats $names using (note(int($1), strcol(4))) nooutput
plot for [k=0:count-1] $fronts using ($1 == k ? $2 : NaN):3 with linespoints lw 1.8 pt 7 ps 0.35 lc rgb tone[k % 8 + 1] title called[k + 1], \
     for [k=0:count-1] $stars using ($1 == k ? $2 : NaN):3 with points pt 3 ps 1.3 lw 1.4 lc rgb tone[k % 8 + 1] title called[k + 1].', the setting of the paper', \
     for [k=0:count-1] $names using ($1 == k ? $2 : NaN):3:4 with labels left offset 0.6, (k % 2 ? 0.35 : -0.35) noenhanced tc rgb tone[k % 8 + 1] notitle
