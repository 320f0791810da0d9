# Spin after an oblique impact against its angle. Given: blocks curve, computed and measured (degrees, rad/s).
set terminal svg size 760, 380 font 'sans-serif,15' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics 0, 15 offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set lmargin at screen 0.115
set rmargin at screen 0.97
set bmargin at screen 0.16
set tmargin at screen 0.97
set xrange [0:90]
set yrange [0:*]
set xlabel 'angle of the impact, from the normal [degrees]' offset 0, 0.4
set ylabel 'spin after it [rad/s]' offset 1.2, 0
set key bottom center Left reverse samplen 2
plot $curve using 1:2 with lines lw 2 lc rgb '#0072b2' title 'furrow', \
     $computed using 1:2 with points pt 6 ps 0.9 lw 1.5 lc rgb '#d55e00' title 'computed: Chung and Ooi 2011', \
     $measured using 1:2 with points pt 9 ps 0.9 lc rgb '#009e73' title 'measured: Kharaz, Gorham and Salman 2001'
