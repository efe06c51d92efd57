function handle = whirl_plot_map(result, plane)
% WHIRL_PLOT_MAP  Draws the regimes of a map over its two parameters.
%   WHIRL_PLOT_MAP(RESULT) draws the number of the regime (result.map.regime.code) of a map that is whole and was not
%   refined, as cells. Gives the handle.
%   WHIRL_PLOT_MAP(RESULT, PLANE) draws that plane of a map over three parameters, from 1; the first one without it.
%
%   See also WHIRL_READ.
table = table_with(result, 'regime', {'map', 'basin'});
if ~isfield(table, 'x') || ~isfield(table, 'y')
    error('whirl:badInput', 'the map is not whole, was refined or has several starts: draw it with ''whirl report''');
end
if nargin < 2
    plane = 1;
end
codes = table.regime.code;
heading = 'regime';
if isfield(table, 'z')
    if ~(plane >= 1 && plane <= numel(table.z) && plane == round(plane))
        error('whirl:badInput', 'the map has %d planes, and no plane %g', numel(table.z), plane);
    end
    codes = reshape(codes(plane, :, :), numel(table.y), numel(table.x));
    heading = sprintf('regime, %s = %g', plain_text(table.attributes.third), table.z(plane));
end
handle = imagesc(table.x(:)', table.y(:)', codes);
set(gca(), 'YDir', 'normal');
xlabel(plain_text(table.attributes.parameter));
ylabel(plain_text(table.attributes.second));
colorbar();
title(heading);
end
