# Colours that colour-blind readers can tell apart: yellow - green - blue (ColorBrewer), light to dark, for magnitudes, blue - grey - orange about zero.
set macros
sequential = "defined (0 '#ffffd9', 1 '#edf8b1', 2 '#c7e9b4', 3 '#7fcdbb', 4 '#41b6c4', 5 '#1d91c0', 6 '#225ea8', 7 '#253494', 8 '#081d58')"
diverging = "defined (0 '#0072b2', 1 '#bbbbbb', 2 '#d55e00')"

# The diverging palette as a number, for a second scale in one plot: z from -1 to 1.
limited(z) = z < -1 ? -1 : z > 1 ? 1 : z
channel(z, low, middle, high) = z < 0 ? middle + (middle - low) * z : middle + (high - middle) * z
colour(z) = 65536 * int(channel(z, 0, 187, 213)) + 256 * int(channel(z, 114, 187, 94)) + int(channel(z, 178, 187, 0))

# One colour for each method in all figures; families of Boost.Odeint are grey.
colour_of_method(name) = name eq 'pece' ? 0x000000 : name eq 'pec' ? 0x8c8c8c : name eq 'pecece' ? 0x595959 : name eq 'ab2' ? 0xcc79a7 : \
  name eq 'pece_adaptive' ? 0x0072b2 : name eq 'symplectic_euler' ? 0xe69f00 : name eq 'verlet' ? 0xa6761d : name eq 'rk4' ? 0x009e73 : \
  name eq 'rkc' ? 0xd55e00 : name[1:6] eq 'odeint' ? 0x9a9a9a : 0x6a3d9a
base_of(name) = strstrt(name, ' +') > 0 ? name[1:strstrt(name, ' +') - 1] : name
