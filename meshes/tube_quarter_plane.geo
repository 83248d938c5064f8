// A quarter of the cross-section of a tube around the x2 axis, radii Ri to Ro in mm: n1 (even) cells
// along the radius, n3 around the quarter. Region: wall. Curves: inner, outer, x1_axis (x3 = 0),
// x3_axis (x1 = 0). Points on x3 = 0: inner_end, middle (half-way), outer_end.
DefineConstant[
  Ri = {1, Name "Ri"}, Ro = {2, Name "Ro"}, n1 = {16, Name "n1", Min 2, Max 500, Step 2},
  n3 = {24, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {Ri, 0, 0};
first[] = Extrude {(Ro-Ri)/2, 0, 0} { Point{1}; Layers{n1/2}; };
second[] = Extrude {(Ro-Ri)/2, 0, 0} { Point{first[0]}; Layers{n1/2}; };
near[] = Extrude {{0, -1, 0}, {0, 0, 0}, Pi/2} { Line{first[1]}; Layers{n3}; Recombine; };
far[] = Extrude {{0, -1, 0}, {0, 0, 0}, Pi/2} { Line{second[1]}; Layers{n3}; Recombine; };
Physical Surface("wall") = {near[1], far[1]};
Physical Curve("inner") = near[3];
Physical Curve("outer") = far[2];
Physical Curve("x1_axis") = {first[1], second[1]};
Physical Curve("x3_axis") = {near[0], far[0]};
Physical Point("inner_end") = 1;
Physical Point("middle") = first[0];
Physical Point("outer_end") = second[0];
