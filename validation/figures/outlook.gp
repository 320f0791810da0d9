# Force against what is varied, three panels. Given: blocks speed, radius, spread (value, mean force, half interval,
# largest force, half interval).
set terminal svg size 900, 360 font 'sans-serif,14' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
stats $speed using ($4 + $5) name 'speeds' nooutput
stats $radius using ($4 + $5) name 'radii' nooutput
stats $spread using ($4 + $5) name 'spreads' nooutput
most(a, b) = a > b ? a : b
set yrange [0:50 * ceil(most(most(speeds_max, radii_max), spreads_max) / 50)]
set style line 1 lc rgb '#0072b2' lw 1.6 pt 7 ps 0.6
set style line 2 lc rgb '#d55e00' lw 1.6 pt 5 ps 0.6 dt (6, 3)
unset key
set ytics offset 0.6, 0
set multiplot
set bmargin at screen 0.19
set tmargin at screen 0.82
set lmargin at screen 0.08
set rmargin at screen 0.36
set ylabel 'force on the plate [N]' offset 0.8, 0
set logscale x
set xrange [0.04:1]
set xtics (0.05, 0.1, 0.2, 0.4, 0.8) offset 0, 0.4
set xlabel 'speed of the plate [m/s]' offset 0, 0.5
set key at screen 0.08, screen 0.99 left top vertical Left reverse samplen 2.2
plot $speed using 1:2:3 with yerrorlines ls 1 title 'mean', $speed using 1:4:5 with yerrorlines ls 2 title 'largest'
unset key
unset logscale x
unset ylabel
set lmargin at screen 0.42
set rmargin at screen 0.67
set xrange [7:16]
set xtics (8, 10, 12.5, 15) offset 0, 0.4
set xlabel 'radius of the particles [mm]' offset 0, 0.5
plot $radius using 1:2:3 with yerrorlines ls 1, $radius using 1:4:5 with yerrorlines ls 2
set lmargin at screen 0.73
set rmargin at screen 0.98
set xrange [-2:32]
set xtics (0, 10, 20, 30) offset 0, 0.4
set xlabel 'spread of the radii [%]' offset 0, 0.5
plot $spread using 1:2:3 with yerrorlines ls 1, $spread using 1:4:5 with yerrorlines ls 2
unset multiplot
