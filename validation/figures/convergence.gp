# Largest force against the time step. Given: blocks forces_1_disc, forces_2_disc, forces_3_disc, forces_2_sphere,
# forces_3_sphere (step ms, N).
set terminal svg size 640, 400 font 'sans-serif,15' enhanced
set lmargin at screen 0.12
set rmargin at screen 0.73
set bmargin at screen 0.15
set tmargin at screen 0.95
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set logscale x
set xrange [0.0017:0.24]
set yrange [0:*]
set xtics ('0.002' 0.002, '0.005' 0.005, '0.01' 0.01, '0.02' 0.02, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2)
set xlabel 'time step [ms]'
set ylabel 'largest force on the plate [N]' offset 1, 0
set key at screen 0.745, 0.93 left top Left reverse samplen 2.2 spacing 1.3
set arrow from 0.1, graph 0 to 0.1, graph 1 nohead lc rgb '#595959' lw 1 dt (4, 3)
set label "the paper's step" at 0.097, graph 0.97 right tc rgb '#595959'
set arrow from 0.0017, 238 to 0.24, 238 nohead lc rgb '#0072b2' lw 1 dt (1, 3)
set arrow from 0.0017, 341 to 0.24, 341 nohead lc rgb '#d55e00' lw 1 dt (1, 3)
set arrow from 0.0017, 363 to 0.24, 363 nohead lc rgb '#007a5a' lw 1 dt (1, 3)
plot $forces_1_disc with linespoints lw 1.6 pt 7 ps 0.7 lc rgb '#0072b2' title 'scene 1', \
     $forces_2_disc with linespoints lw 1.6 pt 5 ps 0.7 lc rgb '#d55e00' title 'scene 2, discs', \
     $forces_2_sphere with linespoints lw 1.6 pt 4 ps 0.7 dt (6, 3) lc rgb '#d55e00' title 'scene 2, spheres', \
     $forces_3_disc with linespoints lw 1.6 pt 9 ps 0.8 lc rgb '#007a5a' title 'scene 3, discs', \
     $forces_3_sphere with linespoints lw 1.6 pt 8 ps 0.8 dt (6, 3) lc rgb '#007a5a' title 'scene 3, spheres'
