# Force on the plate against its displacement. Given: end (mm), bottom, top (N), blocks force (mm fx fy f), peaks (mm f),
# levels (from to value under label; under: 1 if the label goes under the line) and uprights (at label): the numbers of the paper; torn (mm): torn links; band (mm,
# low, high): between which the largest forces of most packings lie, packings: of how many, 0 if unknown.
set terminal svg size 600, 410 font 'sans-serif,16' enhanced
unset key
set lmargin at screen 0.125
set rmargin at screen 0.975
set bmargin at screen (packings > 0 ? 0.2 : 0.145)
set tmargin at screen 0.91
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.4
set ytics offset 0.6, 0
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set xlabel 'displacement of the plate [mm]' offset 0, 0.7
set ylabel 'force on the plate [N]' offset 1.6, 0
set xrange [0:end]
set yrange [bottom:top]
set style line 1 lc rgb '#b0b0b0' lw 3
set style line 2 lc rgb '#0072b2' lw 1.2
set style line 3 lc rgb '#d55e00' lw 1.2 dt (6, 2)
set style line 4 lc rgb '#007a5a' lw 2 dt (2, 3)
set style line 5 lc rgb '#000000' pt 12 ps 0.7 lw 1

# The key, in one row above the curves.
row = 0.965
array line_at[3] = [0.13, 0.245, 0.355]
array name_of[3] = ['ΣF', 'F_x', 'F_y']
do for [k=1:3] {
  set arrow from screen line_at[k], screen row to screen line_at[k] + 0.045, screen row nohead ls k
  set label name_of[k] at screen line_at[k] + 0.055, screen row left
}
set label '' at screen 0.49, screen row point ls 5
set label 'largest ΣF per 50 mm' at screen 0.51, screen row left
set arrow from screen 0.815, screen row to screen 0.86, screen row nohead ls 4
set label 'the paper' at screen 0.87, screen row left

if (packings > 0) {
  set object 1 rectangle from screen 0.13, screen 0.02 to screen 0.17, screen 0.045 fs solid 1 noborder fc rgb '#e8dff0'
  set label sprintf('largest in 5 mm, 5 to 95 %% of %d packings', packings) at screen 0.18, screen 0.033 left font ',13' tc rgb '#505050'
}
plot $band using 1:2:3 with filledcurves fs solid 1 noborder lc rgb '#e8dff0' title 'packings', \
     $force using 1:4 with lines ls 1 title 'sum', \
     $force using 1:2 with lines ls 2 title 'horizontal', \
     $force using 1:3 with lines ls 3 title 'vertical', \
     $levels using 1:3:($2 - $1):(0) with vectors nohead ls 4, \
     $uprights using 1:(bottom):(0):(top - bottom) with vectors nohead ls 4, \
     $levels using (($1 + $2) / 2):($3 + ($4 > 0 ? -0.035 : 0.035) * (top - bottom)):5 with labels center font ',15' tc rgb '#005f46' noenhanced, \
     $uprights using ($1 > 0.65 * end ? -1e9 : $1):(top - 0.03 * (top - bottom)):2 with labels left offset 0.7, 0 font ',15' tc rgb '#005f46' noenhanced, \
     $uprights using ($1 > 0.65 * end ? $1 : -1e9):(top - 0.03 * (top - bottom)):2 with labels right offset -0.7, 0 font ',15' tc rgb '#005f46' noenhanced, \
     $torn using 1:(bottom):(0):(0.04 * (top - bottom)) with vectors nohead lc rgb '#d00000' lw 1.2 title 'links torn', \
     $peaks using 1:2 with points ls 5
