// Half a section through a ring, or with Ri = 0 a disc, about the x3 axis: [Ri,Ro] x [0,H] in mm, n1
// (even) x n3 quadrilaterals. From the half-way radius outwards each cell is `finer` times as wide as
// the one before. Region: wall. Curves: inner (x1 = Ri), outer, bottom (x3 = 0), top. Points on the
// bottom: inner_end, middle (half-way), outer_end.
DefineConstant[
  Ri = {1, Name "Ri"}, Ro = {2, Name "Ro"}, H = {1, Name "H"}, finer = {1, Name "finer"},
  n1 = {8, Name "n1", Min 2, Max 5000, Step 2}, n3 = {1, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {Ri, 0, 0};
Point(2) = {(Ri+Ro)/2, 0, 0};
Point(3) = {Ro, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Transfinite Curve {1} = n1/2 + 1;
Transfinite Curve {2} = n1/2 + 1 Using Progression finer;
near[] = Extrude {0, 0, H} { Line{1}; Layers{n3}; Recombine; };
far[] = Extrude {0, 0, H} { Line{2}; Layers{n3}; Recombine; };
Physical Surface("wall") = {near[1], far[1]};
Physical Curve("inner") = near[3];
Physical Curve("outer") = far[2];
Physical Curve("bottom") = {1, 2};
Physical Curve("top") = {near[0], far[0]};
Physical Point("inner_end") = 1;
Physical Point("middle") = 2;
Physical Point("outer_end") = 3;
