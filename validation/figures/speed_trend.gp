# Instructions from commit to commit, a panel a kernel. Given: panels, commits, first_commit, last_commit, kernel_0 ..., and block points
# (panel, commit, change [%]). Dashed: what CI lets pass.
columns = 5
rows = (panels + columns - 1) / columns
set terminal svg size 820, 30 + 118 * rows font 'sans-serif,12' noenhanced
stats $points using 3 nooutput
reach = 1.15 * (abs(STATS_max) > abs(STATS_min) ? abs(STATS_max) : abs(STATS_min))
reach = reach < 2.5 ? 2.5 : reach
apart = reach < 4 ? 2 : reach < 15 ? 10 : 20 * ceil(reach / 50)
set multiplot layout rows, columns margins 0.075, 0.985, 0.08, 0.945 spacing 0.035, 0.1
set border 3 lw 0.8
set xrange [-0.4:commits - 0.6]
set yrange [-reach:reach]
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
unset key
set xtics nomirror out scale 0.5 ('' 0, '' commits - 1)
set ytics apart nomirror out scale 0.5 format '%+g %%'
do for [k = 0:panels - 1] {
  set title value(sprintf('kernel_%d', k)) offset 0, -0.9 font ',12'
  if (k >= panels - columns) {
    set label 1 first_commit at graph 0, graph -0.19 left font ',11'
    set label 2 last_commit at graph 1, graph -0.19 right font ',11'
  }
  if (k % columns == 0) { set format y '%+g %%' } else { set format y '' }
  plot 2 with lines lc rgb '#d55e00' lw 1 dt 2, \
       $points using (column(1) == k ? column(2) : NaN):3 with linespoints lc rgb '#0072b2' lw 1.6 pt 7 ps 0.7
}
unset multiplot
