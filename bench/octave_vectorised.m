% The peer Octave, vectorised over 512 machines: rows are coordinates, columns machines.
1; % a script, not a file of functions
function dz = slope(c, s, z, r_k)
    w = 0.2; r_m = 8.4; xi1 = 0.0157509; xi2 = 0.286154;
    rho = 0.08; G = 0.115976; S_f = 0.0045; r_delta = 1.2; r_ck = 10; f = 0.1;
    K1 = 1 / (2 * r_m * w^2); K2 = 1 / (4 * w^2);
    x1 = z(1, :); y1 = z(2, :); x2 = z(3, :); y2 = z(4, :); u2 = z(7, :); v2 = z(8, :);
    c2 = 1 - 2 * s^2; s2 = 2 * s * c;
    direct = r_k + 1 + (r_k - 1) * c2; cross = (r_k - 1) * s2; dx = x1 - x2; dy = y1 - y2;
    sx = direct .* dx + cross .* dy;
    sy = direct .* dy + cross .* dx;
    push = r_ck / (r_m * w^2) * min(r_delta ./ sqrt(x1.^2 + y1.^2) - 1, 0);
    A = x2 - 2 * v2; B = y2 + 2 * u2; q = 1 - x2.^2 - y2.^2; CC = A.^2 + B.^2; C = sqrt(CC); root = sqrt(q);
    P = x2 .* B - y2 .* A; U = x2 .* A + y2 .* B;
    g = (pi + 2 * atan(P ./ (C .* root))) ./ root;
    S2 = -2 * U .* C ./ (q .* CC + P.^2); CV3 = 3 * (2 * C + P .* g) ./ q;
    px = -(x2 .* CV3 + B .* g + A .* S2) ./ q;
    py = -(y2 .* CV3 - A .* g + B .* S2) ./ q;
    dz = [z(5:8, :); -xi1 * z(5, :) - K1 * sx + rho * c + push .* (x1 - f * y1); ...
          -xi1 * z(6, :) - K1 * sy + rho * s - G + push .* (y1 + f * x1); ...
          -0.5 * xi2 * u2 + K2 * sx + S_f * px; -0.5 * xi2 * v2 + K2 * sy + S_f * py - G];
end

machines = 512; steps = 1024; h = 2 * pi / steps;
r_k = linspace(1.0, 0.1, machines); r_k(1) = 0.6;
z = zeros(8, machines); z([2 4], :) = -0.1;
wave = [cos((0:2 * steps) * h / 2); sin((0:2 * steps) * h / 2)];
revolutions = 20; best = Inf;
for revolution = 1:revolutions
    start = cputime();
    for n = 1:2:2 * steps
        k1 = slope(wave(1, n), wave(2, n), z, r_k);
        k2 = slope(wave(1, n + 1), wave(2, n + 1), z + h / 2 * k1, r_k);
        k3 = slope(wave(1, n + 1), wave(2, n + 1), z + h / 2 * k2, r_k);
        k4 = slope(wave(1, n + 2), wave(2, n + 2), z + h * k3, r_k);
        z = z + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    end
    best = min(best, cputime() - start);
end
printf("Octave vectorised\t%.6g\t%.13f\n", machines * steps / best, z(1, 1));
