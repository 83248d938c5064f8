// The x1-x3 plane of bilayer.geo: two bonded layers of H/2 each, [0,H] x [0,L] in mm, n1 (even) x
// n3 quadrilaterals. Regions: active (x1 < H/2), passive. Curves: outer (x1 = 0), interface,
// back (x1 = H), x3_min, x3_max. Points: pin (x1 = H/2, x3 = 0), tip (x1 = H/2, x3 = L).
DefineConstant[
  L = {20, Name "L"}, H = {1, Name "H"}, n1 = {4, Name "n1", Min 2, Max 500, Step 2},
  n3 = {20, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {0, 0, 0};
lower[] = Extrude {H/2, 0, 0} { Point{1}; Layers{n1/2}; };
upper[] = Extrude {H/2, 0, 0} { Point{lower[0]}; Layers{n1/2}; };
active[] = Extrude {0, 0, L} { Line{lower[1]}; Layers{n3}; Recombine; };
passive[] = Extrude {0, 0, L} { Line{upper[1]}; Layers{n3}; Recombine; };
e = H * 1e-6;
Physical Surface("active") = active[1];
Physical Surface("passive") = passive[1];
Physical Curve("outer") = Curve In BoundingBox {-e, -e, -e, e, e, L+e};
Physical Curve("interface") = Curve In BoundingBox {H/2-e, -e, -e, H/2+e, e, L+e};
Physical Curve("back") = Curve In BoundingBox {H-e, -e, -e, H+e, e, L+e};
Physical Curve("x3_min") = Curve In BoundingBox {-e, -e, -e, H+e, e, e};
Physical Curve("x3_max") = Curve In BoundingBox {-e, -e, L-e, H+e, e, L+e};
Physical Point("pin") = Point In BoundingBox {H/2-e, -e, -e, H/2+e, e, e};
Physical Point("tip") = Point In BoundingBox {H/2-e, -e, L-e, H/2+e, e, L+e};
