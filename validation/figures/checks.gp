# One dot a check. Given: rows, blocks checks (error over tolerance, row, 1 if it failed) and names (row, largest; name of the page).
set terminal svg size 760, 72 + 15 * rows font 'sans-serif,12' noenhanced
unset key
set lmargin at screen 0.32
set rmargin at screen 0.97
set bmargin at screen 58.0 / (72 + 15 * rows)
set tmargin at screen 1 - 8.0 / (72 + 15 * rows)
set border 1 lw 0.8
set logscale x
set xrange [7e-7:200]
set yrange [rows - 0.4:-0.6]
set xtics ('1e-6' 1e-6, '1e-5' 1e-5, '1e-4' 1e-4, '0.001' 1e-3, '0.01' 1e-2, '0.1' 0.1, '1' 1, '10' 10, 'not a number' 100) nomirror
unset ytics
set xlabel 'error over tolerance [-]'
set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb '#d55e00' lw 1.5
set label 'fails' at 1.2, graph 0.985 tc rgb '#a33b00'
plot $names using (7.001e-7):1:3 with labels right offset -0.6, 0 notitle, \
     $checks using 1:($2 + 0.5 * (rand(0) - 0.5)):($3 > 0 ? 0xd55e00 : 0x0072b2) with points pt 7 ps 0.22 lc rgb variable notitle
