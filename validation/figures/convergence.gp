# Largest force against the time step. Given: blocks forces_1_disc, forces_2_disc, forces_3_disc, forces_2_sphere,
# forces_3_sphere (step ms, N).
set terminal svg size 900, 430 font 'sans-serif,15' enhanced
set lmargin at screen 0.095
set rmargin at screen 0.77
set bmargin at screen 0.165
set tmargin at screen 0.96
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set logscale xy
set xrange [0.0017:0.24]
set yrange [40:1500]
set xtics ('0.002' 0.002, '0.005' 0.005, '0.01' 0.01, '0.02' 0.02, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2) offset 0, 0.4
set ytics (50, 100, 200, 300, 500, 1000) offset 0.6, 0
set xlabel 'time step [ms]' offset 0, 0.5
set ylabel 'largest force on the plate [N]' offset 0.8, 0
set key at screen 0.785, 0.52 left top Left reverse samplen 2.2 spacing 1.3
set arrow from 0.1, graph 0 to 0.1, graph 1 nohead lc rgb '#595959' lw 1 dt (4, 3)
set label "the paper's step" at 0.096, graph 0.955 right tc rgb '#595959'
set arrow from 0.0017, 238 to 0.24, 238 nohead lc rgb '#0072b2' lw 1.2 dt (2, 3)
set arrow from 0.0017, 341 to 0.24, 341 nohead lc rgb '#d55e00' lw 1.2 dt (2, 3)
set arrow from 0.0017, 363 to 0.24, 363 nohead lc rgb '#007a5a' lw 1.2 dt (2, 3)
set label 'the paper, scene 3: 363 N' at screen 0.785, first 400 left tc rgb '#007a5a' font ',14'
set label 'scene 2: 341 N' at screen 0.785, first 325 left tc rgb '#d55e00' font ',14'
set label 'scene 1: 238 N' at screen 0.785, first 238 left tc rgb '#0072b2' font ',14'
plot $forces_1_disc with linespoints lw 1.6 pt 7 ps 0.7 lc rgb '#0072b2' title 'scene 1', \
     $forces_2_disc with linespoints lw 1.6 pt 5 ps 0.7 lc rgb '#d55e00' title 'scene 2, discs', \
     $forces_2_sphere with linespoints lw 1.6 pt 4 ps 0.7 dt (6, 3) lc rgb '#d55e00' title 'scene 2, spheres', \
     $forces_3_disc with linespoints lw 1.6 pt 9 ps 0.8 lc rgb '#007a5a' title 'scene 3, discs', \
     $forces_3_sphere with linespoints lw 1.6 pt 8 ps 0.8 dt (6, 3) lc rgb '#007a5a' title 'scene 3, spheres'
