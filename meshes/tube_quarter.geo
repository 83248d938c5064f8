// A quarter of a tube around the x2 axis, radii Ri to Ro and length H in mm: n1 (even) cells along the
// radius, n2 along the length, n3 around the quarter. Region: wall. Surfaces: inner, outer, x1_axis
// (x3 = 0), x3_axis (x1 = 0), x2_min, x2_max. Points on x3 = 0: inner_end, middle (half-way), outer_end.
DefineConstant[
  Ri = {1, Name "Ri"}, Ro = {2, Name "Ro"}, H = {1, Name "H"},
  n1 = {16, Name "n1", Min 2, Max 500, Step 2}, n2 = {1, Name "n2", Min 1, Max 500, Step 1},
  n3 = {24, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {Ri, 0, 0};
Point(2) = {(Ri+Ro)/2, 0, 0};
Point(3) = {Ro, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Transfinite Curve {1, 2} = n1/2 + 1;
first[] = Extrude {0, H, 0} { Line{1}; Layers{n2}; Recombine; };
second[] = Extrude {0, H, 0} { Line{2}; Layers{n2}; Recombine; };
near[] = Extrude {{0, -1, 0}, {0, 0, 0}, Pi/2} { Surface{first[1]}; Layers{n3}; Recombine; };
far[] = Extrude {{0, -1, 0}, {0, 0, 0}, Pi/2} { Surface{second[1]}; Layers{n3}; Recombine; };
Physical Volume("wall") = {near[1], far[1]};
Physical Surface("x2_min") = {near[2], far[2]};
Physical Surface("outer") = far[3];
Physical Surface("x2_max") = {near[4], far[4]};
Physical Surface("inner") = near[5];
Physical Surface("x1_axis") = {first[1], second[1]};
Physical Surface("x3_axis") = {near[0], far[0]};
Physical Point("inner_end") = 1;
Physical Point("middle") = 2;
Physical Point("outer_end") = 3;
