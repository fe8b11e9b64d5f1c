// A slope of 2 horizontal to 1 vertical on a rigid base at the level of its toe.
DefineConstant[ height = 10, run = 2, crest = 15 ];

Point(1) = {0, 0, 0};
Point(2) = {run * height + crest, 0, 0};
Point(3) = {run * height + crest, height, 0};
Point(4) = {run * height, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("soil") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("crest") = {3};
Physical Curve("face") = {4};
