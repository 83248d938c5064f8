// A quarter of a circular membrane around the x2 axis, radius B, and half of its thickness H, in mm; the
// electrode covers the radius A. Cells: a square of n x n around the axis, then n_a rings to the
// electrode's edge and n_b to the frame, n2 through the half thickness. Region: membrane. Surfaces:
// middle (x2 = 0, the middle plane), electrode (x2 = H/2, radius < A), frame (radius B), x1_min
// (x1 = 0), x3_min. Lines: edge (of the electrode, radius A, on the x1 axis, through the thickness).
DefineConstant[
  A = {4, Name "A"}, B = {12, Name "B"}, H = {0.5, Name "H"},
  n = {3, Name "n"}, n_a = {2, Name "na"}, n_b = {5, Name "nb"}, n2 = {1, Name "n2"}
];
Point(1) = {0, 0, 0};
c = A / 2;
Point(2) = {c, 0, 0};
Point(3) = {0.85*c, 0, 0.85*c};
Point(4) = {0, 0, c};
For k In {0:1}
  r = k == 0 ? A : B;
  Point(10*k+12) = {r, 0, 0};
  Point(10*k+13) = {r/Sqrt(2), 0, r/Sqrt(2)};
  Point(10*k+14) = {0, 0, r};
  Circle(10*k+11) = {10*k+12, 1, 10*k+13};
  Circle(10*k+12) = {10*k+13, 1, 10*k+14};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
For k In {2:4}
  Line(100+k) = {k, 10+k};
  Line(200+k) = {10+k, 20+k};
EndFor
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {102, 11, -103, -2};
Curve Loop(3) = {103, 12, -104, -3};
Curve Loop(4) = {202, 21, -203, -11};
Curve Loop(5) = {203, 22, -204, -12};
For k In {1:5}
  Plane Surface(k) = {k};
EndFor
Transfinite Curve {1:4, 11, 12, 21, 22} = n + 1;
Transfinite Curve {102:104} = n_a + 1;
Transfinite Curve {202:204} = n_b + 1;
Transfinite Surface {1:5};
Recombine Surface {1:5};
For k In {1:5}
  block[] = Extrude {0, H/2, 0} { Surface{k}; Layers{n2}; Recombine; };
  volumes[] += block[1];
  tops[] += block[0];
  If (k > 3)
    frame[] += block[3];
  EndIf
EndFor
e = H * 1e-6;
Physical Volume("membrane") = volumes[];
Physical Surface("middle") = {1:5};
Physical Surface("electrode") = {tops[0], tops[1], tops[2]};
Physical Surface("frame") = frame[];
Physical Surface("x1_min") = Surface In BoundingBox {-e, -e, -e, e, H/2+e, B+e};
Physical Surface("x3_min") = Surface In BoundingBox {-e, -e, -e, B+e, H/2+e, e};
Physical Curve("edge") = Curve In BoundingBox {A-e, -e, -e, A+e, H/2+e, e};
