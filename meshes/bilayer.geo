// Two bonded layers of H/2 each: [0,H] x [0,W] x [0,L] in mm, n1 (even) x n2 x n3 hexahedra.
// Regions: active (x1 < H/2), passive. Surfaces: outer (x1 = 0), interface (x1 = H/2),
// back (x1 = H), x2_min, x2_max, x3_min, x3_max. Lines: pin (x1 = H/2, x3 = 0) and tip (x3 = L).
DefineConstant[
  L = {20, Name "L"}, W = {4, Name "W"}, H = {1, Name "H"},
  n1 = {4, Name "n1", Min 2, Max 500, Step 2}, n2 = {8, Name "n2", Min 1, Max 500, Step 1},
  n3 = {20, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {0, 0, 0};
edge[] = Extrude {0, W, 0} { Point{1}; Layers{n2}; };
lower[] = Extrude {H/2, 0, 0} { Line{edge[1]}; Layers{n1/2}; Recombine; };
upper[] = Extrude {H/2, 0, 0} { Line{lower[0]}; Layers{n1/2}; Recombine; };
active[] = Extrude {0, 0, L} { Surface{lower[1]}; Layers{n3}; Recombine; };
passive[] = Extrude {0, 0, L} { Surface{upper[1]}; Layers{n3}; Recombine; };
e = H * 1e-6;
Physical Volume("active") = active[1];
Physical Volume("passive") = passive[1];
Physical Surface("outer") = Surface In BoundingBox {-e, -e, -e, e, W+e, L+e};
Physical Surface("interface") = Surface In BoundingBox {H/2-e, -e, -e, H/2+e, W+e, L+e};
Physical Surface("back") = Surface In BoundingBox {H-e, -e, -e, H+e, W+e, L+e};
Physical Surface("x2_min") = Surface In BoundingBox {-e, -e, -e, H+e, e, L+e};
Physical Surface("x2_max") = Surface In BoundingBox {-e, W-e, -e, H+e, W+e, L+e};
Physical Surface("x3_min") = Surface In BoundingBox {-e, -e, -e, H+e, W+e, e};
Physical Surface("x3_max") = Surface In BoundingBox {-e, -e, L-e, H+e, W+e, L+e};
Physical Curve("pin") = Curve In BoundingBox {H/2-e, -e, -e, H/2+e, W+e, e};
Physical Curve("tip") = Curve In BoundingBox {H/2-e, -e, L-e, H/2+e, W+e, L+e};
