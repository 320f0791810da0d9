# Histogram of overlaps, of the radius. Given: first, last (words), apart (width of a bin), blocks start and end (left end of a bin, percent).
set terminal svg size 600, 330 font 'sans-serif,15' enhanced
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set lmargin at screen 0.125
set rmargin at screen 0.975
set bmargin at screen 0.18
set tmargin at screen 0.96
set xlabel 'overlap, of the radius R' offset 0, 0.4
set ylabel 'share of the contacts [%]' offset 1, 0
set xrange [0:2]
set yrange [0:*]
set style fill solid 0.75 noborder
set boxwidth 0.42 * apart absolute
set arrow from 1, graph 0 to 1, graph 1 nohead lw 1 dt (4, 4) lc rgb '#a33b00'
set label 'centre at the surface' at 1.02, graph 0.72 left tc rgb '#a33b00' font ',13'
set key top right Left reverse samplen 1
plot $start using ($1 + 0.27 * apart):2 with boxes lc rgb '#9ecae1' title first, \
     $end using ($1 + 0.73 * apart):2 with boxes lc rgb '#08519c' title last
