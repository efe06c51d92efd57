% Right-hand sides and forces of elements: beside closed forms, and beside whirl's own motion; wrong arguments.
function wrong(call, part)
  try
    call();
  catch problem
    assert(~isempty(strfind(problem.identifier, 'whirl:')), problem.message);
    assert(~isempty(strfind(problem.message, part)), problem.message);
    return
  end
  error('no error: %s', func2str(call));
end

% A disc on springs with a rub: forces by hand. Rub at radius r beyond the gap: normal kappa (r - gap), friction 0.05.
case_text = fileread([getenv('TESTS') '/cli/good.yaml']);
m = whirl_machine(case_text, 'omega', 2, 'kappa', 12);
assert(m.stations, {'disc'});
assert(m.speed, 2);
x = [1.2; 0.9; 0.3; -0.2];
t = 0.7;
r = hypot(x(1), x(2));
shaft = whirl_element('shaft', m, t, x);
assert(shaft, -x(1:2), -1e-14);
rub = whirl_element('rub', m, t, x);
normal = -12 * (r - 1) * x(1:2) / r;
friction = 0.05 * 12 * (r - 1) * [x(2); -x(1)] / r;
assert(rub, normal + friction, 1e-13);
assert(whirl_element('rub', m, t, [0.5; 0.2; 0; 0]), [0; 0]);
assert(whirl_element('gravity', m, t, x), [0; -0.5], 1e-15);
unbalance = 0.9 * 2^2 * [cos(2 * t); sin(2 * t)];
dxdt = whirl_rhs(m, t, x);
assert(dxdt(1:2), x(3:4), 1e-15);
assert(dxdt(3:4), shaft + rub + [0; -0.5] - 0.2 * x(3:4) + unbalance, 1e-12);

wrong(@() whirl_rhs(m, t, x(1:3)), '4 real numbers');
wrong(@() whirl_rhs(m, t, single(x)), 'double');
wrong(@() whirl_rhs(m, t, x + 1i), 'real');
wrong(@() whirl_rhs(m, [], x), 't is not');
wrong(@() whirl_rhs(m, t, {1, 2, 3, 4}), 'double');
wrong(@() whirl_rhs(7, t, x), 'expected a machine');
wrong(@() whirl_element('film', m, t, x), 'no element');
wrong(@() whirl_element('rub[2]', m, t, x), 'no element');
wrong(@() whirl_element(repmat('a', 1, 999), m, t, x), 'at most 255');
wrong(@() whirl_element(3, m, t, x), 'no text');
wrong(@() whirl_machine(case_text, 'kapa', 3), 'kappa');
wrong(@() whirl_machine(sprintf('%srotr: 3\n', case_text)), 'rotr');
wrong(@() whirl_machine('nowhere.yaml'), 'nowhere.yaml');
assert(system('mkfifo pipe.yaml pipe.mat pipe.h5 && mkdir folder.yaml'), 0);
for reads = {@whirl_machine, @whirl_run, @whirl_bearing, @whirl_balance}
  wrong(@() reads{1}('pipe.yaml'), 'is a pipe');
  wrong(@() reads{1}('/dev/zero'), 'is a device');
  wrong(@() reads{1}('folder.yaml'), 'folder');
end
wrong(@() whirl_read('pipe.h5'), 'is a pipe');
wrong(@() whirl_read('pipe.mat'), 'expected a MAT file');
wrong(@() whirl_mex(), 'gateway');
wrong(@() whirl_mex('machine', 3, 4), 'no text');
wrong(@() whirl_mex('rhs', NaN, 1, 1), 'no such machine');
wrong(@() whirl_mex('rhs', 1e9, 1, 1), 'no such machine');
for i = 1:63
  whirl_machine(case_text);
end
wrong(@() whirl_machine(case_text), '64 machines');
whirl_machine('clear', m);
wrong(@() whirl_rhs(m, t, x), 'no such machine');
whirl_machine(case_text, 'kappa', 100);   % takes the place of the cleared one, and not its name
wrong(@() whirl_rhs(m, t, x), 'no such machine');
whirl_machine('clear');
clear whirl_mex;
whirl_machine(case_text);
wrong(@() whirl_rhs(m, t, x), 'no such machine');
whirl_machine('clear');

% The example: the film's force in a script's own equations gives the motion of whirl's equations. Both go by ode45 to
% 1e-9 a step; the two agree to rounding, which 8 revolutions of a motion that does not diverge hardly enlarge.
warning('off', 'all');   % Octave discourages from gnuplot, which draws without a screen
graphics_toolkit('gnuplot');
figure('visible', 'off');
given_case = [getenv('CASES') '/rigid-rotor.yaml'];
film_with_ode45;
assert(difference < 1e-8);
print('-dpngcairo', 'film.png');

% ... and beside the command's own motion: sections by dop853 at 1e-11 of 8 revolutions from the same start.
one = strrep(fileread(given_case), ...
  'integrate: {method: rk4, steps_per_revolution: 512, transient: 600, record: 200}', ...
  'integrate: {method: dop853, rtol: 1e-11, atol: 1e-13, transient: 0, record: 8}');
one = regexprep(one, '  sweep: [^\n]*', '  response: {}');
one = regexprep(one, '  detail: [^\n]*', '');
one = regexprep(one, 'analyze: [^\n]*', 'analyze: [poincare]');
own = whirl_run(one, 'progress', false);
sections = squeeze(own.response.poincare.section(1, 1, :, 1:2));
fprintf('beside the command: %.2g\n', max(max(abs(sections - hand(101:100:801, 1:2)))));
assert(sections, hand(101:100:801, 1:2), 1e-6);
clear whirl_mex;
disp('all well');
