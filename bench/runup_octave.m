% The peer Octave at the run-up of runup.yaml: ode45 over the equations of runup_peers.c. Prints the seconds of
% processor time, x and y at the end, m, and the speed there, rad/s.
1; % a script, not a file of functions
function dz = slope(t, z)
    mass = 10; damping = 40; stiffness = 1e5; e = 0.5e-3; inertia = 0.5; torque = 3; no_load = 100 * pi;
    c = cos(z(3)); s = sin(z(3)); w = z(6);
    X = (-damping * z(4) - stiffness * z(1)) / mass + e * w^2 * c;
    Y = (-damping * z(5) - stiffness * z(2)) / mass + e * w^2 * s;
    turn = (torque * (1 - w / no_load) + mass * e * (X * s - Y * c)) / inertia;
    dz = [z(4:6); X + e * turn * s; Y - e * turn * c; turn];
end

rtol = str2double(argv(){1});
start = cputime;
[t, z] = ode45(@slope, [0 20 40], zeros(6, 1), odeset('RelTol', rtol, 'AbsTol', 1e-6 * rtol));
printf('%g %.17g %.17g %.17g\n', cputime - start, z(end, 1), z(end, 2), z(end, 6));
