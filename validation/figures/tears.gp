# Torn links on the lattice at its start. Given: x0, x1, y0, y1 (of the nodes, m), from, to (mm), blocks links (x y dx dy), torn (x y dx dy mm kind
# number; kind 2: bending) and nodes (x y).
wide = 230.0
tall = (y1 - y0) > 0 ? (y1 - y0) : 1
across = (x1 - x0) > 0 ? (x1 - x0) : tall / 4
high = 0.62 * wide * tall / across
high = high < 260 ? 260 : high > 640 ? 640 : high
set terminal svg size 430, high + 40 font 'sans-serif,14' enhanced
unset key
unset border
unset tics
set lmargin at screen 0.06
set rmargin at screen 0.7
set tmargin at screen 0.98
set bmargin at screen 0.03
set xrange [x0 - 0.3 * across:x1 + 0.3 * across]
set yrange [y0 - 0.04 * tall:y1 + 0.04 * tall]
set palette defined (0 '#41b6c4', 0.5 '#225ea8', 1 '#081d58')
set cbrange [from:to]
set colorbox user origin screen 0.78, 0.2 size 0.04, 0.6
set cbtics nomirror scale 0.5
set cblabel 'plate at [mm]' offset 1, 0
plot $links using 1:2:3:4 with vectors nohead lw 1 lc rgb '#d0d0d0', \
     $torn using ($6 == 2 ? NaN : $1):2:3:4:5 with vectors nohead lw 3 lc palette, \
     $torn using ($6 == 2 ? $1 : NaN):2:3:4:5 with vectors nohead lw 1.5 dt (4, 3) lc palette, \
     $nodes using 1:2 with points pt 7 ps 0.5 lc rgb '#404040', \
     $torn using ($1 + 0.5 * $3 + ($6 == 2 ? 0.05 * across : 0)):($2 + 0.5 * $4):7 with labels font ',11' tc rgb '#a30000'
