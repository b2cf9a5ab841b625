<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.8" name="meadow" tilewidth="16" tileheight="16" tilecount="8" columns="4">
 <properties><property name="season" value="spring"/></properties>
 <image source="meadow.png" width="64" height="32"/>
 <tile id="0" class="soil" probability="0.5"><properties><property name="digs" type="bool" value="true"/></properties>
  <objectgroup><object id="1" x="0" y="0" width="16" height="16"/></objectgroup></tile>
 <tile id="3"><animation><frame tileid="3" duration="120"/><frame tileid="5" duration="240"/></animation></tile>
 <wangsets><wangset name="path" type="corner" tile="-1"><wangcolor name="gravel" color="#aa8844" tile="-1" probability="1"/>
  <wangtile tileid="2" wangid="0,1,0,1,0,1,0,1"/></wangset></wangsets>
</tileset>
