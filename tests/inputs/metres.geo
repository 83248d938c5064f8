// In m, which Mesh.ScalingFactor makes mm.
Mesh.ScalingFactor = 1000;
Point(1) = {0, 0, 0};
a[] = Extrude {0.004, 0, 0} { Point{1}; Layers{2}; };
s[] = Extrude {0, 0, 0.001} { Line{a[1]}; Layers{1}; Recombine; };
Physical Surface("film") = s[1];
Physical Curve("base") = a[1];
Physical Curve("lid") = s[0];
