% The peer Octave on the overhung rotor: its stiff solvers ode15s and lsode, over 20 revolutions.
%
%   overhung_octave.m MATRICES
1; % a script, not a file of functions
function [fx, fy] = film(scale, x, y, vx, vy)
    A = x - 2 * vy; B = y + 2 * vx; q = 1 - x^2 - y^2; CC = A^2 + B^2; C = sqrt(CC); root = sqrt(q);
    P = x * B - y * A; U = x * A + y * B;
    g = (pi + 2 * atan(P / (C * root))) / root;
    S2 = -2 * U * C / (q * CC + P^2); CV3 = 3 * (2 * C + P * g) / q;
    fx = -scale / q * (x * CV3 + B * g + A * S2);
    fy = -scale / q * (y * CV3 - A * g + B * S2);
end
function dz = slope(t, z, m)
    F = zeros(6, 1); v = z(23:44);
    [F(1), F(2)] = film(m.film(1), z(1), z(2), v(1), v(2));
    [F(3), F(4)] = film(m.film(2), z(3), z(4), v(3), v(4));
    r = sqrt(z(5)^2 + z(6)^2);
    if r > m.gap
        push = max(m.push * (r - m.gap) + m.damping * (z(5) * v(5) + z(6) * v(6)) / r, 0) / r;
        F(5) = -push * (z(5) - m.friction * z(6));
        F(6) = -push * (z(6) + m.friction * z(5));
    end
    dz = [v; -m.K * z(1:22) - m.G * v + m.P * F + cos(t) * m.u + sin(t) * m.w - m.g];
end

rows = load("-ascii", argv(){end});
speed = 628; clearance = 80e-6; radius = [0.02, 0.025]; width = [0.025, 0.03];
m.K = rows(1:22, :); m.G = rows(23:44, :); m.P = rows(45:50, :)';
m.g = rows(51, :)'; m.u = rows(52, :)'; m.w = rows(53, :)';
m.film = 0.02 * radius .* width.^3 / (4 * clearance^3 * speed);
m.gap = 150e-6 / clearance; m.push = 20e6 / speed^2; m.damping = 500 / speed; m.friction = 0.1;
z = zeros(44, 1); z([2 4 6]) = [-0.3 -0.6 -0.8];
revolutions = 20; span = [0, 2 * pi * revolutions];

start = cputime();
options = odeset("RelTol", 1e-6, "AbsTol", 1e-9, "InitialStep", 1e-6);
[~, path] = ode15s(@(t, z) slope(t, z, m), span, z, options);
printf("Octave ode15s\t%.6g\t%.13f\n", revolutions / (cputime() - start), path(end, 2));

start = cputime();
lsode_options("integration method", "stiff");
lsode_options("relative tolerance", 1e-6);
lsode_options("absolute tolerance", 1e-9);
lsode_options("step limit", 1000000);
path = lsode(@(z, t) slope(t, z, m), z, span);
printf("Octave lsode\t%.6g\t%.13f\n", revolutions / (cputime() - start), path(end, 2));
