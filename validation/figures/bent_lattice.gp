# Deflection along a clamped lattice, of Timoshenko's at the end. Given: count, slender (length over height), blocks cells (number, place, deflection) and
# names (number, name).
set terminal svg size 760, 360 font 'sans-serif,15' enhanced
array called[20]
note(k, name) = (called[k] = name, 1)
stats $names using (note(int($1), strcol(2))) nooutput
set border 3 lw 0.8
set tics nomirror out scale 0.6
set xtics offset 0, 0.3
set ytics offset 0.6, 0
set grid ytics lc rgb '#e2e2e2' lw 0.6 dt 1
set lmargin at screen 0.1
set rmargin at screen 0.78
set bmargin at screen 0.19
set tmargin at screen 0.97
set xlabel 'place along the lattice, of its length' offset 0, 0.4
set ylabel 'deflection' offset 0.8, 0
set xrange [0:1]
set yrange [1.05:0]
set key at screen 0.79, 0.95 left top Left reverse samplen 2
array tone[6] = [0xa6cee3, 0x56b4e9, 0x0072b2, 0x08306b, 0x000000, 0x000000]
# E = 8/3 G, I = 1/12, kappa = 5/6, height 1: bending and shear, of their sum at the end.
bending(x) = slender**3 * x**2 * (3 - x) / 2 / (3 * 8.0 / 3 / 12)
shear(x) = slender * x / (5.0 / 6)
beam(x) = (bending(x) + shear(x)) / (bending(1) + shear(1))
plot beam(x) with lines lw 4 lc rgb '#d0d0d0' title 'Timoshenko', \
     for [k = 1:count] $cells using ($1 == k ? $2 : NaN):3 with linespoints lw 1.4 pt 7 ps 0.35 lc rgb tone[k] title called[k]
