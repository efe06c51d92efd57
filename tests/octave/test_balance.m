% Weights out of files and structs are those of the command: a rigid rotor of two planes whose unbalance is known.
function wrong(call, part)
  try
    call();
  catch problem
    assert(problem.identifier, 'whirl:badInput');
    assert(~isempty(strfind(problem.message, part)), problem.message);
    return
  end
  error('no error: %s', func2str(call));
end
corpus = [getenv('TESTS') '/fuzz/corpus/balance/two-planes.yaml'];
found = whirl_balance(corpus);
expected = -[2e-3 * exp(1i * pi / 6), 1.2e-3 * exp(1i * 10 * pi / 9)];
planes = {found.correction.near, found.correction.far};
for p = 1:2
  assert(planes{p}.moment * exp(1i * planes{p}.angle), expected(p), 1e-10);
end
assert([planes{2}.holes.hole], 2);   % 15 degrees apart, the first at 5
assert(max(arrayfun(@(row) row.after.amplitude, found.vibration)) < 1e-12);
assert(found.unbalance, 3.2e-3, 1e-9);

readings = [1 64.84229701 26.200279; 2 107.08616462 10.113970];
file = struct('angles', 'with', 'phases', 'lead');
file.planes = {struct('name', 'near')};
file.trials = {struct('run', 2, 'plane', 'near', 'moment', 1e-3, 'angle', 0)};
for r = 1:2
  file.vibration{r} = struct('run', readings(r, 1), 'speed', 500, 'probe', 'left', ...
    'amplitude', readings(r, 2) * 1e-6, 'phase', sprintf('%.9g deg', readings(r, 3)));
end
seen = readings(:, 2) .* exp(1i * pi / 180 * readings(:, 3));
one = whirl_balance(file);
assert(one.correction.near.moment * exp(1i * one.correction.near.angle), -1e-3 * seen(1) / (seen(2) - seen(1)), 1e-9);
file.phases = 'lags';
wrong(@() whirl_balance(file), 'phases: is lags, did you mean lag?');
wrong(@() whirl_balance('none.yaml'), 'none.yaml');
wrong(@() whirl_balance(3), 'whirl_balance takes the name of a file');
disp('all well');
