# One snapshot, true to scale. Given: width, height, strip (px), x0, x1, y0, y1 (m), caption, stress_top (kPa), force_top (N),
# weight (1 or 0), the files links and plates of a run's frame, and blocks walls (point, normal) and discs (x y radius and stress,
# or -1 for the outline).
set terminal svg size width, height font 'sans-serif,15' noenhanced
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1 - strip / height
unset border
unset tics
unset key
unset colorbox
set xrange [x0:x1]
set yrange [y0:y1]
set palette @sequential
set cbrange [0:stress_top]
set label 1 caption at screen 6 / width, screen 1 - 0.45 * strip / height left font ',16'

metre = width / (x1 - x0)      # px
size(r) = r * metre / 5.625    # gnuplot draws a point of size 1 with a radius of 0.375 of the font's size
far = 10 * (x1 - x0 + y1 - y0)
bending(kind) = kind eq 'bending' ? 1 : NaN
other(kind) = kind eq 'bending' ? NaN : 1
disc_colour(stress) = stress < 0 ? 0x808080 : palette(stress > stress_top ? stress_top : stress)
shade(force) = colour(limited(force / force_top))

# Arrows: velocity of a plate beside it, or left of it at the end of its way; gravity in the corner.
long = 0.09 * (x1 - x0)
above = y1 - 30 / metre
tail(left, width) = left + width + 1.5 * long < x1 ? left + width : left - 1.2 * long
if (weight) {
  set arrow from x0 + long / 3, y1 - 5 / metre rto 0, -0.75 * long filled size screen 9 / width, 22 lw 2 front
  set label 'g' at x0 + long / 2, y1 - 5 / metre - 0.4 * long font ',16' front
}
plot $discs using 1:2:(size($3)):(disc_colour($4)) with points pt 7 ps variable lc rgb variable, \
     plates using ($1 + $3 / 2):($2 + $4 / 2):1:($1 + $3):2:($2 + $4) skip 1 with boxxyerror fs solid 1 noborder lc rgb '#666666', \
     $walls using ($1 - far * $4):($2 + far * $3):(2 * far * $4):(-2 * far * $3) with vectors nohead lw 3 lc rgb '#222222', \
     links using ($1 * bending(strcol(6))):2:($3 - $1):($4 - $2):(shade($5)) skip 1 with vectors nohead lw (0.0035 * metre) lc rgb variable, \
     links using ($1 * other(strcol(6))):2:($3 - $1):($4 - $2):(shade($5)) skip 1 with vectors nohead lw (0.0013 * metre) lc rgb variable, \
     links using 1:2 skip 1 with points pt 7 ps (size(0.0011)) lc rgb '#222222', \
     links using 3:4 skip 1 with points pt 7 ps (size(0.0011)) lc rgb '#222222', \
     plates using (tail($1, $3)):(above):(long * $5 / sqrt($5 ** 2 + $6 ** 2)):(long * $6 / sqrt($5 ** 2 + $6 ** 2)) skip 1 \
       with vectors head filled size screen 9 / width, 22 lw 2 lc rgb '#000000', \
     plates using (tail($1, $3) + long / 2):(above):('v') skip 1 with labels offset 0, 0.7 font ',16' tc rgb '#000000'
