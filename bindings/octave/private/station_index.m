function index = station_index(result, station)
% STATION_INDEX  The number of a station: by its name, by its number, or [] for the first.
index = index_of_name(result.stations.name, station, 'station');
end
