// Examples of the library. Each returns what main.cpp compares with a closed form.
#pragma once

double largest_force_on_the_plate();     // N
double fall_by_an_own_method(double h);  // m, after 1 s, by steps of h [s]
double speed_with_an_own_force();        // m/s, after 1 s
