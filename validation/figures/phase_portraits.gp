# A spring in the plane of place and velocity, one panel a method. Given: count, reach, blocks points (method, place, velocity) and panels (method,
# last amplitude, name).
columns = 4
rows = (int(count) + columns - 1) / columns
set terminal svg size 820, 30 + 215 * rows font 'sans-serif,14' noenhanced
unset key
set border 3 lw 0.8
set tics nomirror out scale 0.5
set size square
set xrange [-reach:reach]
set yrange [-reach:reach]
set xtics (-2, -1, 0, 1, 2) offset 0, 0.4
set ytics (-2, -1, 0, 1, 2) offset 0.6, 0
array called[50]
array last[50]
note(k, r, name) = (called[k + 1] = name, last[k + 1] = r, 1)
stats $panels using (note(int($1), $2, strcol(3))) nooutput
set parametric
set trange [0:2 * pi]
set multiplot layout rows, columns margins 0.055, 0.985, 0.25 / rows, 1 - 0.09 / rows spacing 0.03, 0.26 / rows
do for [k = 0:count - 1] {
  set title sprintf('%s: %.2f', called[k + 1], last[k + 1]) offset 0, -0.8 tc rgb colour_of_method(called[k + 1])
  if (k % columns == 0) { set ylabel 'velocity' offset 1.2, 0 } else { unset ylabel }
  if (k >= count - columns) { set xlabel 'place' offset 0, 0.8 } else { unset xlabel }
  plot cos(t), sin(t) with lines lw 3 lc rgb '#c8c8c8' title 'exact', \
       $points using ($1 == k ? $2 : NaN):3 with linespoints lw 1 pt 7 ps 0.25 lc rgb colour_of_method(called[k + 1]) title called[k + 1]
}
unset multiplot
