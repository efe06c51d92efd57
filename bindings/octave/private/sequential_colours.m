function colours = sequential_colours()
% SEQUENTIAL_COLOURS  The colours of numbers from small to large, dark to light: viridis, which MATLAB has not.
anchors = colour({'#440154', '#482878', '#3E4A89', '#31688E', '#26828E', '#1F9E89', '#35B779', '#6DCD59', '#B4DE2C', ...
    '#FDE725'});
colours = interp1(linspace(0, 1, size(anchors, 1)), anchors, linspace(0, 1, 64));
end
