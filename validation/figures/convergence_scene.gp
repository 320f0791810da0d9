# A scene's largest force and the energy that the method makes, against the time step. Given: blocks forces_literal, forces_best
# (step ms, N), made_literal, made_best (step ms, % of what the scene was given; a millionth stands for what is less).
set terminal svg size 900, 380 font 'sans-serif,15' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set logscale xy
set xrange [0.0017:0.24]
set xtics ('0.002' 0.002, '0.01' 0.01, '0.05' 0.05, '0.2' 0.2) offset 0, 0.4
set xlabel 'time step [ms]' offset 0, 0.5
set arrow from 0.1, graph 0 to 0.1, graph 1 nohead lc rgb '#595959' lw 1 dt (4, 3)
set style line 1 lc rgb '#0072b2' lw 1.6 pt 7 ps 0.6
set style line 2 lc rgb '#d55e00' lw 1.6 pt 5 ps 0.6 dt (6, 3)
set multiplot layout 1, 2 margins 0.09, 0.98, 0.18, 0.86 spacing 0.11
set key at screen 0.09, screen 0.99 left top horizontal Left reverse samplen 2.2
set ylabel 'largest force [N]' offset 0.8, 0
set yrange [10:2000]
plot $forces_literal with linespoints ls 1 title 'literal reading', $forces_best with linespoints ls 2 title 'best valid reading'
unset key
set ylabel 'energy made [%]' offset 0.8, 0
set yrange [5e-5:1000]
set format y '%g'
plot $made_literal with linespoints ls 1, $made_best with linespoints ls 2
unset multiplot
