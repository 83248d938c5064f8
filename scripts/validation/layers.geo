// Two bonded layers ha and hb thick, L long, in mm, in the x1-x3 plane: na, nb cells through them, n3 along.
// Regions: a (x1 < ha), b. Curves: outer (x1 = 0), interface, back, root (x3 = 0), end. Points on the
// interface: pin (x3 = 0), tip (x3 = L).
DefineConstant[
  L = {20, Name "L"}, ha = {0.5, Name "ha"}, hb = {0.5, Name "hb"},
  na = {1, Name "na", Min 1, Max 99, Step 1}, nb = {1, Name "nb", Min 1, Max 99, Step 1},
  n3 = {20, Name "n3", Min 1, Max 999, Step 1}
];
Point(1) = {0, 0, 0};
lower[] = Extrude {ha, 0, 0} { Point{1}; Layers{na}; };
upper[] = Extrude {hb, 0, 0} { Point{lower[0]}; Layers{nb}; };
first[] = Extrude {0, 0, L} { Line{lower[1]}; Layers{n3}; Recombine; };
second[] = Extrude {0, 0, L} { Line{upper[1]}; Layers{n3}; Recombine; };
H = ha + hb;
e = 1e-6*H;
Physical Surface("a") = first[1];
Physical Surface("b") = second[1];
Physical Curve("outer") = Curve In BoundingBox {-e, -e, -e, e, e, L+e};
Physical Curve("interface") = Curve In BoundingBox {ha-e, -e, -e, ha+e, e, L+e};
Physical Curve("back") = Curve In BoundingBox {H-e, -e, -e, H+e, e, L+e};
Physical Curve("root") = Curve In BoundingBox {-e, -e, -e, H+e, e, e};
Physical Curve("end") = Curve In BoundingBox {-e, -e, L-e, H+e, e, L+e};
Physical Point("pin") = Point In BoundingBox {ha-e, -e, -e, ha+e, e, e};
Physical Point("tip") = Point In BoundingBox {ha-e, -e, L-e, ha+e, e, L+e};
