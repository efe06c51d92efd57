function handle = whirl_plot_map(result)
% WHIRL_PLOT_MAP  Draws the regimes of a map over its two parameters.
%   WHIRL_PLOT_MAP(RESULT) draws the number of the regime (result.map.regime.code) of a map that is whole and was not
%   refined, as cells. Gives the handle.
%
%   See also WHIRL_READ.
table = table_with(result, 'regime', {'map', 'basin'});
if ~isfield(table, 'x') || ~isfield(table, 'y')
    error('whirl:badInput', 'the map is not whole, was refined or has several starts: draw it with ''whirl report''');
end
handle = imagesc(table.x(:)', table.y(:)', table.regime.code);
set(gca(), 'YDir', 'normal');
xlabel(plain_text(table.attributes.parameter));
ylabel(plain_text(table.attributes.second));
colorbar();
title('regime');
end
