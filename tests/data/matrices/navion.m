% Navion at sea level, stability axes (Teper, NASA CR-96008), rounded to four digits.
% units: ft-slug-s
U0 = 176.0;                              % ft/s
states = {'u', 'w', 'q', 'theta'};
inputs = {'elevator'};
A = [ -0.04505   0.03604     0      -32.174
      -0.3694   -2.023     176.0      0
       0.001908 -0.03952    -2.986    0
       0         0           1        0    ];
B = [ 0; -28.15; -11.06; 0 ];
sys = ss(A, B, eye(4), zeros(4, 1));
