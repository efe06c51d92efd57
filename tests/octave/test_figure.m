% Figures in Octave are what their description says: limits, ticks, labels, colours, numbers, names in legends.
warning('off', 'all');
graphics_toolkit('gnuplot');
function list = items(decoded)
  if iscell(decoded)
    list = decoded(:);
  else
    list = num2cell(decoded(:));
  end
end
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
function text = plain(label)   % a label without the marks of italics and indices
  text = strrep(regexprep(strrep(label, '$', ''), '_\{(\w*)\}', '_$1'), char(10), '\n');
end
function text = seen(label)
  text = regexprep(regexprep(label, '\{\\it ([^{}]*)\}', '$1'), '_\{(\w*)\}', '_$1');
  text = regexprep(text, '\\([\\_^{}])', '$1');
end
function check_axis(handle, which, axis_data)
  assert(get(handle, [which 'lim']), [axis_data.low, axis_data.high]);
  assert(strcmp(get(handle, [which 'scale']), 'log') == axis_data.log);
  label = get(get(handle, [which 'label']), 'string');
  if axis_data.shown
    assert(seen(label), plain(axis_data.label));
  else
    assert(isempty(label));
  end
  if isfield(axis_data, 'ticks')
    assert(get(handle, [which 'tick'])(:), axis_data.ticks(:));
    texts = cellstr(get(handle, [which 'ticklabel']));
    if axis_data.shown
      assert(cellfun(@seen, texts(:), 'UniformOutput', false), ...
             cellfun(@plain, cellstr(axis_data.tick_texts)(:), 'UniformOutput', false));
    else
      assert(all(cellfun(@isempty, texts)));
    end
  end
end
function rgb = mixed(series)
  rgb = 1 - series.opacity * (1 - hex2dec(reshape(series.colour(2:end), 2, 3)')' / 255);
end
function check_series(handles, series)   % HANDLES are what was drawn of it
  x = series.x(:);
  y = series.y(:);
  switch series.shape
    case {'dots', 'line'}
      assert(numel(handles) == 1);
      assert(isequaln(get(handles, 'xdata')(:), x) && isequaln(get(handles, 'ydata')(:), y));
      assert(get(handles, 'color'), mixed(series), 1e-12);
    case 'bars'
      assert(get(handles, 'xdata')(2:3:end)(:), x);
      assert(get(handles, 'ydata')(1:3:end)(:), y);
      assert(get(handles, 'ydata')(2:3:end)(:), series.y_to(:));
    case 'boxes'
      corners = get(handles, 'vertices');
      there = ~isnan(x) & ~isnan(y);
      if isfield(series, 'values')
        there = there & ~isnan(series.values(:));
      end
      assert(corners(1:4:end, :), [x(there), y(there)]);
      assert(corners(3:4:end, :), [series.x_to(there)(:), series.y_to(there)(:)]);
      if ~isfield(series, 'values')
        assert(get(handles, 'facevertexcdata')(1, :), mixed(series), 1e-12);
      end
    case 'area'
      drawn = zeros(0, 3);
      for handle = handles(:)'
        assert(get(handle, 'facecolor'), mixed(series), 1e-12);
        corners = [get(handle, 'xdata')(:), get(handle, 'ydata')(:)];
        half = rows(corners) / 2;
        assert(corners(1:half, 1), flipud(corners(half + 1:end, 1)));
        drawn = [drawn; corners(1:half, :), flipud(corners(half + 1:end, 2))];
      end
      numbers = [x, y, series.y_to(:)];
      assert(drawn, numbers(~any(isnan(numbers), 2), :));
    case 'texts'
      assert(cellfun(@seen, get(handles, {'string'}), 'UniformOutput', false), ...
             cellfun(@plain, cellstr(series.texts)(:), 'UniformOutput', false));
  end
end
function count = pieces(series)   % how many objects a series is
  count = 0;
  if ~isfield(series, 'x') || isempty(series.x)
    return
  end
  count = 1;
  if strcmp(series.shape, 'texts')
    count = numel(cellstr(series.texts));
  elseif strcmp(series.shape, 'area')
    there = ~isnan(series.x(:)) & ~isnan(series.y(:)) & ~isnan(series.y_to(:));
    count = sum(diff([false; there]) == 1);
  end
end
function names = expected_names(panels)
  names = {};
  for panel = panels(:)'
    if ~panel{1}.legend_inside
      for series = items(panel{1}.series)'
        if ~isempty(series{1}.name) && ~any(strcmp(names, series{1}.name))
          names{end + 1} = series{1}.name;
        end
      end
    end
  end
end
function shapes = check_figure(drawn)
  panels = items(drawn.data.panels);
  shapes = {};
  assert(numel(drawn.axes) == numel(panels));
  for i = 1:numel(panels)
    axes_handle = drawn.axes(i);
    box = panels{i}.box(:)';
    assert(get(axes_handle, 'position'), [box(1), box(3), box(2) - box(1), box(4) - box(3)], 1e-12);
    if ~panels{i}.equal
      check_axis(axes_handle, 'x', panels{i}.x);
      check_axis(axes_handle, 'y', panels{i}.y);
    end
    children = flipud(allchild(axes_handle));
    titles = cell2mat(get(axes_handle, {'xlabel', 'ylabel', 'zlabel', 'title'}));
    children = children(~ismember(children, titles));
    at = 0;
    for series = items(panels{i}.series)'
      count = pieces(series{1});
      if count > 0
        check_series(children(at + (1:count)), series{1});
      end
      at = at + count;
      shapes{end + 1} = series{1}.shape;
    end
    assert(at == numel(children));
  end
  names = expected_names(panels);
  assert(isempty(drawn.legend) == isempty(names));
  if ~isempty(names)
    printed = get(flipud(findobj(drawn.legend, 'type', 'text')), {'string'});
    printed = cellfun(@seen, printed(~cellfun(@isempty, printed)), 'UniformOutput', false);
    assert(sort(printed(:)), sort(cellfun(@plain, names(:), 'UniformOutput', false)));
  end
  assert(isempty(drawn.scale) == ~isfield(drawn.data, 'scale'));
  if ~isempty(drawn.scale)
    ends = [drawn.data.scale.low, drawn.data.scale.high];
    ticks = get(drawn.scale, 'ytick');
    if drawn.data.scale.log
      assert(ends(1) * (ends(2) / ends(1)) .^ ticks(:), drawn.data.scale.ticks(:), -1e-9);
    else
      assert(ends(1) + diff(ends) * ticks(:), drawn.data.scale.ticks(:), 1e-9 * max(abs(ends)));
    end
    assert(cellfun(@seen, cellstr(get(drawn.scale, 'yticklabel'))(:), 'UniformOutput', false), ...
           cellfun(@plain, cellstr(drawn.data.scale.tick_texts)(:), 'UniformOutput', false));
    bar = findobj(drawn.scale, 'type', 'patch');
    first = hex2dec(reshape(drawn.data.scale.colours{1}(2:end), 2, 3)')' / 255;
    assert(get(bar, 'facevertexcdata')(1, :), first, 0.05);
    assert(seen(get(get(drawn.scale, 'ylabel'), 'string')), plain(drawn.data.scale.label));
  end
end
figure('visible', 'off');
shapes = {};
cases = {'cli/good', 'cli/branch', 'cli/tori', 'cli/modes', 'octave/map_of_clearance'};
for i = 1:numel(cases)
  [~, name] = fileparts(cases{i});
  file = [name '.h5'];
  whirl_run([getenv('TESTS') '/' cases{i} '.yaml'], 'output', file, 'progress', false);
  names = whirl_figure(file, 'list');
  assert(~isempty(names));
  for k = 1:numel(names)
    shapes = [shapes, check_figure(whirl_figure(file, names{k}))];
    if k == 1
      print('-dpngcairo', [name '.png']);
      found = dir([name '.png']);
      assert(found.bytes > 1500);
    end
  end
end
assert(all(ismember({'dots', 'line', 'area', 'boxes', 'texts'}, shapes)));

% Panels, units and axes are chosen; without a name it is the first figure that is not the machine.
drawn = whirl_figure('good.h5');
names = whirl_figure('good.h5', 'list');
assert(drawn.data.name, names{find(~strcmp(names, 'rotor'), 1)});
drawn = whirl_figure('good.h5', '', 'panels', 'radius', 'units', 'um, rpm', 'log', 'x');
assert(numel(drawn.axes) == 1 && strcmp(get(drawn.axes, 'xscale'), 'log'));
assert(~isempty(strfind(get(get(drawn.axes, 'ylabel'), 'string'), 'µm')));
assert(~isempty(strfind(get(get(drawn.axes, 'xlabel'), 'string'), 'rpm')));

wrong(@() whirl_figure('good.h5', 'bifurcation-disk'), 'did you mean bifurcation-disc');
wrong(@() whirl_figure('good.h5', '', 'panels', 'z'), 'no panel');
wrong(@() whirl_figure('good.h5', '', 'units', 'rpn'), 'did you mean rpm');
wrong(@() whirl_figure('good.h5', '', 'colour', 'red'), 'no option');
wrong(@() whirl_figure(3), 'the name of a result file');
wrong(@() whirl_figure([getenv('TESTS') '/cli/good.yaml']), 'good.yaml');
disp('all well');
