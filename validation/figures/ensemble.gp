# Distribution functions of the largest force. Given: paper_two, paper_three (N), blocks two_disc, two_sphere, three_disc, three_sphere (N, share).
set terminal svg size 900, 400 font 'sans-serif,15' enhanced
set lmargin at screen 0.085
set rmargin at screen 0.77
set bmargin at screen 0.17
set tmargin at screen 0.94
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.4
set ytics offset 0.6, 0
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set yrange [0:1]
set xrange [0:*]
set xlabel 'largest force on the plate [N]' offset 0, 0.5
set ylabel 'share of the packings below it' offset 0.8, 0
set key at screen 0.785, 0.93 left top Left reverse samplen 2.2 spacing 1.3
set label sprintf('paper, scene 2: %.0f N', paper_two) at paper_two, 0.1 right offset -0.6, 0 tc rgb '#b34700' font ',14'
set label sprintf('scene 3: %.0f N', paper_three) at paper_three, 0.04 left offset 0.6, 0 tc rgb '#005f46' font ',14'
set arrow from paper_two, graph 0 to paper_two, graph 1 nohead lc rgb '#d55e00' lw 1.2 dt (2, 3)
set arrow from paper_three, graph 0 to paper_three, graph 1 nohead lc rgb '#007a5a' lw 1.2 dt (2, 3)
plot $two_disc with steps lw 1.8 lc rgb '#d55e00' title 'scene 2, discs', \
     $two_sphere with steps lw 1.8 dt (6, 3) lc rgb '#d55e00' title 'scene 2, spheres', \
     $three_disc with steps lw 1.8 lc rgb '#007a5a' title 'scene 3, discs', \
     $three_sphere with steps lw 1.8 dt (6, 3) lc rgb '#007a5a' title 'scene 3, spheres'
