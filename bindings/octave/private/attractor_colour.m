function rgb = attractor_colour(number)
% ATTRACTOR_COLOUR  The colour of an attractor by its number; 0 is none.
%   Okabe and Ito's colours over and over, in an order in which neighbours differ in lightness, too.
colours = {'#0072B2', '#E69F00', '#56B4E9', '#009E73', '#CC79A7', '#D55E00', '#F0E442', '#000000'};
rgb = colour('#9A9F95');
if number > 0
    rgb = colour(colours{mod(number - 1, numel(colours)) + 1});
end
end
