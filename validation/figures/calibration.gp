# A measured force curve and the calibrated one. Given: component, blocks measured and best (mm, N).
set terminal svg size 600, 380 font 'sans-serif,16' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set xlabel 'displacement of the plate [mm]'
set ylabel component . ' [N]'
set key outside top left horizontal Left reverse samplen 2
plot $measured using 1:2 with points pt 7 ps 0.35 lc rgb '#d55e00' title 'measured', \
     $best using 1:2 with lines lw 1.4 lc rgb '#0072b2' title 'best setting'
