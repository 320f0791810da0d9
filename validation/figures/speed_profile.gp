# Share of instructions by part of the solver, a row a part, a mark a scene. Given: count, and block dots (scene 1, 2, 3 [%], part).
set terminal svg size 820, 100 + 26 * count font 'sans-serif,15' noenhanced
set lmargin at screen 0.33
set rmargin at screen 0.97
set bmargin at screen 66.0 / (100 + 26 * count)
set tmargin at screen 1 - 34.0 / (100 + 26 * count)
set border 1 lw 0.8
set xrange [0:*]
set xtics nomirror out scale 0.6
set grid xtics ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set xlabel 'share of instructions [%]' offset 0, 0.3
set yrange [count - 0.5:-0.5]
set ytics scale 0 nomirror
set key at graph 1, screen 0.99 right top horizontal samplen 1
plot $dots using 1:0:yticlabels(4) with points pt 5 ps 0.9 lc rgb '#e69f00' title 'scene 1: plate, lattice', \
     $dots using 2:0 with points pt 7 ps 0.9 lc rgb '#0072b2' title '2: plate, discs', \
     $dots using 3:0 with points pt 8 ps 1.1 lw 1.6 lc rgb '#000000' title '3: all'
