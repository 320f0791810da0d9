# A colour scale. Given: low, high, title, and palette_name, 'sequential' or 'diverging'.
set terminal svg size 420, 62 font 'sans-serif,15' noenhanced
set lmargin at screen 0.06
set rmargin at screen 0.94
set bmargin at screen 0.42
set tmargin at screen 0.62
if (palette_name eq 'sequential') { set palette @sequential } else { set palette @diverging }
unset key
unset ytics
unset colorbox
set xrange [low:high]
set yrange [0:1]
set cbrange [low:high]
set xtics out nomirror scale 0.4 offset 0, 0.3
set label 1 title at graph 0, screen 0.82 left
set samples 2
set isosamples 2, 2
n = 120
set border lw 0.5
set style fill solid 1 noborder
plot sample [i=0:n-1:1] '+' using (low + (i + 0.5) * (high - low) / n):(0.5):(low + i * (high - low) / n):(low + (i + 1) * (high - low) / n):(0):(1):(low + (i + 0.5) * (high - low) / n) with boxxyerror lc palette
