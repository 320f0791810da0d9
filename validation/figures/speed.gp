# Ratios of CPU time, one line a program. Given: count, and block dots (least, median, most, kind, name): kind 0 furrow, 1 a program that
# agrees on the physics, 2 one that does not.
set terminal svg size 820, 90 + 42 * count font 'sans-serif,15' noenhanced
set lmargin at screen 0.31
set rmargin at screen 0.96
set bmargin at screen 70.0 / (90 + 42 * count)
set tmargin at screen 0.97
set border 1 lw 0.8
set logscale x
unset key
set xtics nomirror out scale 0.6 (0.5, 1, 2, 3, 5, 10, 20, 50)
set grid xtics lc rgb '#e2e2e2' lw 0.6 dt 1
set xlabel 'CPU time of a step over that of furrow with one evaluation' offset 0, 0.3
set yrange [count - 0.5:-0.5]
set ytics scale 0 nomirror
shade(kind) = kind == 0 ? 0xd55e00 : kind == 1 ? 0x0072b2 : 0x808080
mark(kind) = kind == 2 ? 6 : 7
plot $dots using 2:0:1:3:(shade($4)):yticlabels(5) with xerrorbars pt 0 lw 1.6 lc rgb variable, \
     $dots using 2:($0):(mark($4)):(shade($4)) with points pt variable ps 1 lw 1.6 lc rgb variable
