# Observed and predicted orders, methods by kinds of force. Given: width, height (in cells), blocks cells (column row order
# missed text; order -1: the method cannot carry it), wanted (column row text), columns (column 0 title), rows (0 row name).
names = 5.4  # cells
room = 1.2

heads = 3.7
cell_wide = 1080 / (width + names + room)
cell_tall = 38.0
set terminal svg size 1080, cell_tall * (height + heads) font 'sans-serif,13' noenhanced
unset key
unset colorbox
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set xrange [-0.5 - names:width - 0.5 + room]
set yrange [height - 0.5:-0.5 - heads]
set border 0
unset xtics
unset ytics
# Light throughout, so that black figures stand out, in print too.
set palette defined (0 '#fff3c4', 1 '#fde0a0', 2 '#d3ebc5', 3 '#a9d8d3', 4 '#a5c9ea', 5 '#c3bfe9')
set cbrange [0:5]
half = 0.48
set style fill solid 1 noborder
plot $cells using 1:2:($1 - half):($1 + half):($2 - half):($2 + half):($3 < 0 ? NaN : $3 > 5 ? 5 : $3) with boxxyerror lc palette, \
     $cells using ($4 > 0 ? $1 : NaN):2:($1 - half):($1 + half):($2 - half):($2 + half) with boxxyerror fs empty border rgb '#a33b00' lw 3, \
     $cells using 1:($3 < 0 ? $2 : $2 - 0.17):(strcol(5)) with labels font ',13', \
     $wanted using 1:($2 + 0.26):(strcol(3)) with labels font ',11.5' tc rgb '#4d4d4d', \
     $columns using ($1 - 0.25):(-0.62):(strcol(3)) with labels rotate by 40 left font ',14', \
     $rows using (-0.62):2:(strcol(3)) with labels right font ',12.5'
