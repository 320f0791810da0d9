# Misfit of the settings tried for the first scene. Given: own_spacing (mm), own_rows, block settings (spacing mm, depth in
# spacings, misfit), best first.
set terminal svg size 860, 470 font 'sans-serif,15' enhanced
unset key
set lmargin at screen 0.09
set rmargin at screen 0.83
set bmargin at screen 0.15
set tmargin at screen 0.94
set border 3 lw 0.8
set tics nomirror out scale 0.6
set logscale xy
set xtics (5, 7, 10, 15, 20, 30) offset 0, 0.4
set ytics (0.3, 0.5, 1, 2, 3, 4, 5, 6) offset 0.6, 0
set xrange [4.6:33]
set yrange [0.27:6.7]
set xlabel 'spacing of the lattice [mm]' offset 0, 0.5
set ylabel 'depth of the plate below the highest row [spacings]' offset 0.8, 0
set cblabel 'misfit (dark: good)' offset 0.5, 0
set cbrange [*:5]
set palette @sequential negative  # the best are dark
set label 'scene file' at own_spacing, own_rows offset -1, -1.1 right tc rgb '#d55e00' front
stats $settings using 1:2 every ::0::0 name 'best' nooutput
set label 'best' at best_mean_x, best_mean_y offset 1.2, 0.9 left front
plot $settings using 1:2:3 with points pt 7 ps 0.45 lc palette, \
     $settings every ::0::0 using 1:2 with points pt 4 ps 1.5 lw 2 lc rgb '#000000', \
     '+' using (own_spacing):(own_rows) every ::0::0 with points pt 2 ps 1.1 lw 2 lc rgb '#d55e00'
