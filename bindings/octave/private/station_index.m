function index = station_index(result, station)
% STATION_INDEX  Returns the number of a station from its name, its number, or [] for the first.
index = index_of_name(result.stations.name, station, 'station');
end
