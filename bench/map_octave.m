% The peer Octave over a map: lsode, point after point (map_equations.h).
%
%   map_octave.m TRANSIENT RECORD STRIDE
1; % a script, not a file of functions
function dz = slope(z, t, r_k, rho)
    w = 0.2; r_m = 8.4; xi1 = 0.0157509; xi2 = 0.286154;
    G = 0.115976; S_f = 0.0045; r_delta = 1.2; r_ck = 10; f = 0.1;
    a = r_k + 1; b = r_k - 1; dx = z(1) - z(3); dy = z(2) - z(4); c = cos(t); s = sin(t);
    sx = (a + b * cos(2 * t)) * dx + b * sin(2 * t) * dy;
    sy = (a + b * cos(2 * t)) * dy + b * sin(2 * t) * dx;
    push = r_ck / (r_m * w^2) * min(r_delta / sqrt(z(1)^2 + z(2)^2) - 1, 0);
    A = z(3) - 2 * z(8); B = z(4) + 2 * z(7); q = 1 - z(3)^2 - z(4)^2; CC = A^2 + B^2; C = sqrt(CC); root = sqrt(q);
    P = z(3) * B - z(4) * A; U = z(3) * A + z(4) * B;
    g = (pi + 2 * atan(P / (C * root))) / root; S2 = -2 * U * C / (q * CC + P^2); CV3 = 3 * (2 * C + P * g) / q;
    K1 = 1 / (2 * r_m * w^2); K2 = 1 / (4 * w^2);
    dz = [z(5:8); -xi1 * z(5) - K1 * sx + rho * c + push * (z(1) - f * z(2)); ...
          -xi1 * z(6) - K1 * sy + rho * s + push * (z(2) + f * z(1)) - G; ...
          -0.5 * xi2 * z(7) + K2 * sx - S_f * (z(3) * CV3 + B * g + A * S2) / q; ...
          -0.5 * xi2 * z(8) + K2 * sy - S_f * (z(4) * CV3 - A * g + B * S2) / q - G];
end

words = argv(); numbers = cellfun(@str2double, words(end - 2:end));
transient = numbers(1); record = numbers(2); stride = numbers(3); side = 16; perturbation = 1e-8;
lsode_options("integration method", "adams");
lsode_options("relative tolerance", 1e-6);
lsode_options("absolute tolerance", 1e-9);
lsode_options("step limit", 1000000);
watched = transient - floor(transient / 2); section = 0; points = 0;
start = cputime();
for point = 0:stride:side^2 - 1
    r_k = 1 - 0.9 * mod(point, side) / (side - 1); rho = 0.04 + 0.08 * floor(point / side) / (side - 1);
    machine = @(z, t) slope(z, t, r_k, rho);
    z = [0; -0.1; 0; -0.1; 0; 0; 0; 0]; growth = 0; largest = 0;
    for n = 0:transient + record - 1
        if n == watched
            twin = z; twin(1) += perturbation;
        end
        path = lsode(machine, z, linspace(0, 2 * pi, 65)); z = path(end, :)';
        if n >= watched
            other = lsode(machine, twin, [0, 2 * pi]);
            apart = other(end, :)' - z; distance = norm(apart);
            growth += log(distance / perturbation); twin = z + apart * (perturbation / distance);
        end
        if n >= transient
            section += z(1); largest = max(largest, max(hypot(path(:, 1), path(:, 2))));
        end
    end
    points++;
end
printf("Octave lsode\t%.6g\t%.9f\n", (cputime() - start) / points, section / (points * record));
