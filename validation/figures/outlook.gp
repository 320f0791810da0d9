# Force against what is varied, three panels. Given: blocks speed, radius, spread (value, mean force, half interval,
# largest force, half interval).
set terminal svg size 860, 330 font 'sans-serif,14' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set yrange [0:*]
set style line 1 lc rgb '#0072b2' lw 1.6 pt 7 ps 0.6
set style line 2 lc rgb '#d55e00' lw 1.6 pt 5 ps 0.6 dt (6, 3)
set key off
set multiplot
set bmargin at screen 0.17
set tmargin at screen 0.85
set lmargin at screen 0.08
set rmargin at screen 0.36
set ylabel 'force on the plate [N]' offset 1.5, 0
set logscale x
set xrange [0.04:1]
set xlabel 'speed of the plate [m/s]'
set key at screen 0.08, 0.97 left top horizontal Left reverse samplen 2.2 width 2
plot $speed using 1:2:3 with yerrorlines ls 1 title 'mean', $speed using 1:4:5 with yerrorlines ls 2 title 'largest'
set key off
unset logscale x
unset ylabel
set lmargin at screen 0.43
set rmargin at screen 0.67
set xrange [7:16]
set xlabel 'radius of the particles [mm]'
plot $radius using 1:2:3 with yerrorlines ls 1, $radius using 1:4:5 with yerrorlines ls 2
set lmargin at screen 0.74
set rmargin at screen 0.98
set xrange [-2:32]
set xlabel 'spread of the radii [%]'
plot $spread using 1:2:3 with yerrorlines ls 1, $spread using 1:4:5 with yerrorlines ls 2
unset multiplot
