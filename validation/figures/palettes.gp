# Colours that colour-blind readers can tell apart: yellow - green - blue (ColorBrewer), light to dark, for magnitudes, blue - grey - orange about zero.
set macros
sequential = "defined (0 '#ffffd9', 1 '#edf8b1', 2 '#c7e9b4', 3 '#7fcdbb', 4 '#41b6c4', 5 '#1d91c0', 6 '#225ea8', 7 '#253494', 8 '#081d58')"
diverging = "defined (0 '#0072b2', 1 '#bbbbbb', 2 '#d55e00')"

# The diverging palette as a number, for a second scale in one plot: z from -1 to 1.
limited(z) = z < -1 ? -1 : z > 1 ? 1 : z
channel(z, low, middle, high) = z < 0 ? middle + (middle - low) * z : middle + (high - middle) * z
colour(z) = 65536 * int(channel(z, 0, 187, 213)) + 256 * int(channel(z, 114, 187, 94)) + int(channel(z, 178, 187, 0))
