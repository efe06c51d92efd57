function bar = colour_bar(axes_handle, label, colours)
% COLOUR_BAR  The colours of numbers, for these axes, and a bar beside them that tells what they are called.
colormap(axes_handle, colours);
% Beside a bar gnuplot leaves no more room to the labels than the place of the axes does.
place = get(axes_handle, 'Position');
if ~isappdata(axes_handle, 'whirl_place')
    setappdata(axes_handle, 'whirl_place', place_of(axes_handle));
end
set(axes_handle, 'Position', place .* [1, 1, 0.87, 0.88] + [0.03 * place(3), 0.07 * place(4), 0, 0]);
bar = colorbar(axes_handle);
set(get(bar, 'Label'), 'String', label, 'Interpreter', 'none', 'FontSize', 9);
end

function place = place_of(axes_handle)
% What a figure without a bar puts back: the axes' place in the way in which it was told, with or without their labels.
name = 'Position';
if strcmpi(get(axes_handle, 'ActivePositionProperty'), 'outerposition')
    name = 'OuterPosition';
end
place = {name, get(axes_handle, name)};
end
