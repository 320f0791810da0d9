# The finding: largest force against the time step, of that at the finest. Given: blocks shares_1_disc, shares_2_disc, shares_3_disc,
# shares_2_sphere, shares_3_sphere (step ms, share).
set terminal svg size 620, 350 font 'sans-serif,15' enhanced
set lmargin at screen 0.11
set rmargin at screen 0.74
set bmargin at screen 0.18
set tmargin at screen 0.97
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set logscale xy
set xrange [0.0017:0.24]
set yrange [0.5:30]
set xtics ('0.002' 0.002, '0.01' 0.01, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2) offset 0, 0.4
set ytics ('0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10, '20' 20) offset 0.6, 0
set xlabel 'time step [ms]' offset 0, 0.5
set ylabel 'largest force, of that at the finest step' offset 0.8, 0
unset key
set arrow from 0.1, graph 0 to 0.1, graph 1 nohead lc rgb '#595959' lw 1 dt (4, 3)
set label "the paper's step" at 0.093, graph 0.955 right tc rgb '#595959'
set label 'scene 3, spheres' at screen 0.75, first 17.6 left tc rgb '#007a5a'
set label 'scene 2, spheres' at screen 0.75, first 3.7 left tc rgb '#a33b00'
set label 'discs:' at screen 0.75, first 1.5 left
set label 'scenes 1, 2, 3' at screen 0.75, first 1.1 left
plot $shares_1_disc with linespoints lw 2 pt 7 ps 0.6 lc rgb '#0072b2' title 'scene 1', \
     $shares_2_disc with linespoints lw 2 pt 7 ps 0.6 lc rgb '#d55e00' title 'scene 2, discs', \
     $shares_3_disc with linespoints lw 2 pt 7 ps 0.6 lc rgb '#007a5a' title 'scene 3, discs', \
     $shares_2_sphere with linespoints lw 2 pt 5 ps 0.6 dt (6, 3) lc rgb '#d55e00' title 'scene 2, spheres', \
     $shares_3_sphere with linespoints lw 2 pt 5 ps 0.6 dt (6, 3) lc rgb '#007a5a' title 'scene 3, spheres'
