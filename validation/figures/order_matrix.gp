# Observed and predicted orders, methods by kinds of force. Given: width, height (in cells), blocks cells (column row order
# missed text; order -1: the method cannot carry it), columns (column 0 title), rows (0 row name).
set terminal svg size 1080, 130 + 30 * height font 'sans-serif,13' noenhanced
unset key
unset colorbox
set lmargin at screen 0.17
set rmargin at screen 0.995
set tmargin at screen 1 - 125.0 / (130 + 30 * height)
set bmargin at screen 5.0 / (130 + 30 * height)
set xrange [-0.5:width - 0.5]
set yrange [height - 0.5:-0.5]
set border 0
unset xtics
unset ytics
# Light throughout, so that black figures stand out, in print too.
set palette defined (0 '#fff3c4', 1 '#fde0a0', 2 '#d3ebc5', 3 '#a9d8d3', 4 '#9cc3e6', 5 '#b9b4e3')
set cbrange [0:5]
half = 0.485
set style fill solid 1 noborder
plot $cells using 1:2:($1 - half):($1 + half):($2 - half):($2 + half):($3 < 0 ? NaN : $3 > 5 ? 5 : $3) with boxxyerror lc palette, \
     $cells using ($4 > 0 ? $1 : NaN):2:($1 - half):($1 + half):($2 - half):($2 + half) with boxxyerror fs empty border lc rgb '#a33b00' lw 2.5, \
     $cells using 1:2:(strcol(5)) with labels font ',12', \
     $columns using 1:(-0.62):3 with labels rotate by 40 left font ',13', \
     $rows using (-0.56):2:3 with labels right font ',13'
